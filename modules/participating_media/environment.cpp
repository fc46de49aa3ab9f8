#include "environment.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/matrix.hpp>

#include "physics/probe.h"
#include "scene/environment.h"

namespace tyndall::participating_media {
namespace {

constexpr int kAngles = 4096;  ///< at which phase functions are looked at

physics::Sh9 project(const TextureAsset& asset) {
    const Image image = small_environment(asset);
    return physics::project_equirect(pixels_of(image), image.width, image.height);
}

float phase_at(const PhaseFunction& phase, float angle) {
    if (phase.kind != PhaseKind::tabulated || !phase.table)
        return physics::phase_evaluate(static_cast<int>(phase.kind), phase.parameters, std::cos(angle));
    const std::vector<glm::vec3>& values = phase.table->values;
    const float at = angle / physics::kPi * static_cast<float>(values.size() - 1);
    const size_t low = std::min(static_cast<size_t>(at), values.size() - 2);
    const glm::vec3 value = glm::mix(values[low], values[low + 1], at - static_cast<float>(low));
    return (value.x + value.y + value.z) / 3.0f;
}

/// 2 pi integral p(u) P_l(u) du for l = 0, 1, 2: what the phase function keeps of each band (Funk-Hecke).
glm::vec3 bands_of(const PhaseFunction& phase) {
    glm::dvec3 sum(0.0);
    for (int i = 0; i < kAngles; ++i) {
        const double angle = double(physics::kPi) * (i + 0.5) / kAngles;
        const double u = std::cos(angle), weight = std::sin(angle) * double(phase_at(phase, static_cast<float>(angle)));
        sum += weight * glm::dvec3(1.0, u, 1.5 * u * u - 0.5);
    }
    return glm::vec3(sum / sum.x);
}

}  // namespace

bool has_environment(const RenderScene& scene) {
    const Environment environment = environment_of(scene);
    return environment.radiance != glm::vec3(0.0f) && environment.lights.count <= 0;
}

void EnvironmentLight::update(const RenderScene& scene, const std::vector<Medium>& media) {
    const Environment source = environment_of(scene);
    if (source.image && source.image->id != image_) {
        image_ = source.image->id;
        image_harmonics_ = project(*source.image);
    }
    harmonics_ = image_harmonics_;
    if (!source.image) {
        harmonics_ = {};
        harmonics_.c[0] = glm::vec4(glm::vec3(1.0f / 0.282094792f), 0.0f);  // radiance 1 everywhere
    }
    for (glm::vec4& c : harmonics_.c) c *= glm::vec4(source.radiance, 0.0f);
    image_from_world_ = glm::transpose(source.world_from_image);
    bands_.resize(media.size());
    phases_.resize(media.size());
    for (size_t i = 0; i < media.size(); ++i) {
        if (phases_[i] == Phase(media[i].phase)) continue;
        phases_[i] = Phase(media[i].phase);
        bands_[i] = bands_of(media[i].phase);
    }
    boxes_.clear();
    for (const LightProbe& probe : scene.probes)
        if (probe.extent_m && boxes_.size() < kMostBoxes)
            boxes_.push_back(
                {glm::inverse(probe.transform), glm::vec4(*probe.extent_m, std::max(probe.blend_m, 1e-4f))});
    weigh_directions();
}

/// Lebedev's rule of 14 directions, each weighed by the light that comes from there too.
void EnvironmentLight::weigh_directions() {
    directions_.clear();
    weights_.clear();
    glm::vec3 sum(0.0f);
    for (int z = -1; z <= 1; ++z)
        for (int y = -1; y <= 1; ++y)
            for (int x = -1; x <= 1; ++x) {
                const int axes = std::abs(x) + std::abs(y) + std::abs(z);
                if (axes != 1 && axes != 3) continue;
                const glm::vec3 direction = glm::normalize(glm::vec3(x, y, z));
                const glm::vec3 light = physics::sh9_evaluate(harmonics_, image_from_world_ * direction);
                const float share = axes == 1 ? 1.0f / 15.0f : 3.0f / 40.0f;
                directions_.emplace_back(direction, 0.0f);
                weights_.push_back(glm::max(light, glm::vec3(1e-6f)) * share);
                sum += weights_.back();
            }
    for (glm::vec3& weight : weights_) weight /= sum;
}

void EnvironmentLight::bind(const gpu::Program& program) const {
    for (size_t i = 0; i < 9; ++i) program.set(fmt::format("environment_harmonics[{}]", i), harmonics_.c[i]);
    program.set("environment_count", static_cast<int>(directions_.size()));
    for (size_t i = 0; i < directions_.size(); ++i) {
        program.set(fmt::format("environment_directions[{}]", i), directions_[i]);
        program.set(fmt::format("environment_weights[{}]", i), weights_[i]);
    }
    for (size_t i = 0; i < bands_.size(); ++i) program.set(fmt::format("environment_bands[{}]", i), bands_[i]);
    program.set("environment_image_from_world", image_from_world_);
    program.set("environment_boxes", static_cast<int>(boxes_.size()));
    for (size_t i = 0; i < boxes_.size(); ++i) {
        program.set(fmt::format("environment_box_from_world[{}]", i), boxes_[i].local_from_world);
        program.set(fmt::format("environment_box_extent[{}]", i), boxes_[i].extent_blend);
    }
}

}  // namespace tyndall::participating_media
