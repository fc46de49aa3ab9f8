#include "epipolar/epipole.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace tyndall::participating_media {
namespace {

/// Half pictures: beyond, lines count as parallel.
constexpr float kFar = 1000.0f;

}  // namespace

glm::vec2 epipole(const Light& light, const glm::mat4& view_projection, glm::ivec2 size) {
    const bool directional = light.kind == LightKind::directional;
    const glm::vec4 place = directional ? glm::vec4(glm::vec3(light.transform[2]), 0.0f) : light.transform[3];
    const glm::vec4 clip = view_projection * place;
    const glm::vec2 across(clip);
    const float least = std::max(glm::length(across) / kFar, 1e-12f);
    const float w = std::copysign(std::max(std::abs(clip.w), least), clip.w);
    return (across / w * 0.5f + 0.5f) * glm::vec2(size);
}

}  // namespace tyndall::participating_media
