#include "media_buffer.h"

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

}  // namespace

const std::vector<Medium>& MediaBuffer::update(const RenderScene& scene, bool enabled) {
    std::array<GpuMedium, kMaximumMedia> records;
    media_.clear();
    for (const Medium& medium : scene.media) {
        const glm::mat4 box = medium_box(medium, scene);
        if (!enabled || glm::determinant(glm::mat3(box)) == 0.0f) continue;
        if (media_.size() == kMaximumMedia) {
            if (!warned_) log::warning("more than {} media: the rest is left out", kMaximumMedia);
            warned_ = true;
            break;
        }
        records[media_.size()] = {glm::inverse(box), glm::vec4(medium.sigma_s_per_m, static_cast<float>(medium.phase.kind)),
                                  glm::vec4(medium.sigma_s_per_m + medium.sigma_a_per_m, 0.0f),
                                  medium.phase.parameters};
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
