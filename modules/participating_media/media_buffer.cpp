#include "media_buffer.h"

#include <fmt/format.h>

#include <array>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/matrix.hpp>
#include <string_view>

#include "core/log.h"

namespace tyndall::participating_media {
namespace {

/// As in shaders/media.glsl.
struct GpuMedium {
    glm::mat4 box_from_world;
    glm::vec4 sigma_s_phase;
    glm::vec4 sigma_t;
    glm::vec4 phase_parameters;
};
static_assert(sizeof(GpuMedium) == 112);

/// What of a medium the shaders cannot render; empty when they can. They know no density but an even one, and no
/// tables.
std::string_view obstacle(const Medium& medium) {
    if (!std::holds_alternative<ConstantDensity>(medium.density)) return "a density that varies";
    if (medium.phase.kind == PhaseKind::tabulated) return "a tabulated phase function";
    return {};
}

}  // namespace

void MediaBuffer::warn_once(std::string_view what) {
    if (!warned_.emplace(what).second) return;
    log::warning("participating_media leaves out {}; the path tracer renders it", what);
}

const std::vector<Medium>& MediaBuffer::update(const RenderScene& scene, bool enabled) {
    std::array<GpuMedium, kMaximumMedia> records;
    media_.clear();
    for (const Medium& medium : scene.media) {
        const glm::mat4 box = medium_box(medium, scene);
        if (!enabled || glm::determinant(glm::mat3(box)) == 0.0f) continue;
        if (const std::string_view what = obstacle(medium); !what.empty()) {
            warn_once("a medium with " + std::string(what));
            continue;
        }
        if (medium.emission_cd_m2_per_m != glm::vec3(0.0f)) warn_once("the light that a medium gives off");
        if (media_.size() == kMaximumMedia) {
            warn_once(fmt::format("all media after the first {}", kMaximumMedia));
            break;
        }
        records[media_.size()] = {
            glm::inverse(box), glm::vec4(medium.sigma_s_per_m, static_cast<float>(medium.phase.kind)),
            glm::vec4(medium.sigma_s_per_m + medium.sigma_a_per_m, 0.0f), medium.phase.parameters};
        media_.push_back(medium);
    }
    const std::string_view bytes(reinterpret_cast<const char*>(records.data()), media_.size() * sizeof(GpuMedium));
    if (buffer_.name() == 0) buffer_ = gpu::Buffer(sizeof(records), nullptr, "media");
    if (bytes == uploaded_) return media_;
    uploaded_ = bytes;
    if (!bytes.empty()) buffer_.update(0, bytes.size(), bytes.data());
    return media_;
}

void MediaBuffer::bind(const gpu::Program& program) const {
    program.block("Media", buffer_);
    program.set("media_count", static_cast<int>(media_.size()));
}

}  // namespace tyndall::participating_media
