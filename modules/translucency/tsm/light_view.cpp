#include "tsm/light_view.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tyndall::translucency {
namespace {

/// The nearest corner over the farthest: nearer to a light, the window would be wider than half of all directions.
constexpr float kNearest = 0.02f;

/// Rigid, looking from `eye` along `forward`, which is the view's +z.
glm::mat4 looking(const glm::vec3& eye, const glm::vec3& forward, const glm::vec3& about_right) {
    const glm::vec3 side = about_right - glm::dot(about_right, forward) * forward;
    const glm::vec3 other = glm::cross(forward, std::abs(forward.x) < 0.8f ? glm::vec3(1, 0, 0) : glm::vec3(0, 1, 0));
    const glm::vec3 right = glm::normalize(glm::dot(side, side) > 1e-4f ? side : other);
    const glm::vec3 up = glm::cross(forward, right);
    const glm::mat3 turn = glm::transpose(glm::mat3(right, up, forward));
    glm::mat4 view(turn);
    view[3] = glm::vec4(-(turn * eye), 1.0f);
    return view;
}

/// From the window's x / k, y / k and z to clip space.
glm::mat4 clip_of(const LightView& view, float near_z, float far_z) {
    const glm::vec2 scale(2.0f / view.size), offset = -scale * view.low - 1.0f;
    glm::mat4 clip(0.0f);
    clip[0][0] = scale.x;
    clip[1][1] = scale.y;
    if (view.perspective) {
        clip[2] = glm::vec4(offset, 0.0f, 1.0f);
        clip[3][2] = near_z;
    } else {
        clip[2][2] = -1.0f / (far_z - near_z);
        clip[3] = glm::vec4(offset, far_z / (far_z - near_z), 1.0f);
    }
    return clip;
}

}  // namespace

std::optional<LightView> light_view(const Light& light, const Mesh& mesh, const glm::mat4& transform, int texels) {
    if (mesh.positions.empty()) return {};
    const glm::vec3 middle(transform * glm::vec4(mesh.bounds.centre(), 1.0f)), place(light.transform[3]);
    LightView view;
    view.perspective = light.kind != LightKind::directional;
    const glm::vec3 forward = view.perspective ? middle - place : -glm::vec3(light.transform[2]);
    if (!(glm::dot(forward, forward) > 0.0f)) return {};
    view.view_from_world =
        looking(view.perspective ? place : middle, glm::normalize(forward), glm::vec3(light.transform[0]));
    view.middle_z = view.perspective ? glm::length(forward) : 0.0f;
    const glm::mat4 view_from_local = view.view_from_world * transform;
    constexpr float kInfinite = std::numeric_limits<float>::infinity();
    glm::vec3 low(kInfinite), high(-kInfinite);
    for (const glm::vec3& position : mesh.positions) {
        glm::vec3 at(view_from_local * glm::vec4(position, 1.0f));
        if (view.perspective) at = glm::vec3(glm::vec2(at) / std::max(at.z, 1e-6f), at.z);
        low = glm::min(low, at);
        high = glm::max(high, at);
    }
    if (view.perspective && low.z < kNearest * high.z) return {};
    view.size = std::max(high.x - low.x, high.y - low.y) * float(texels) / float(texels - 2);
    if (!(view.size > 0.0f) || !std::isfinite(view.size)) return {};
    view.low = 0.5f * (glm::vec2(low) + glm::vec2(high)) - 0.5f * view.size;
    const float margin = 0.01f * view.width_m();
    view.clip_from_world =
        clip_of(view, view.perspective ? 0.5f * low.z : low.z - margin, high.z + margin) * view.view_from_world;
    return view;
}

}  // namespace tyndall::translucency
