#include "scatter_maps/scatter_view.h"

#include <algorithm>
#include <cmath>

namespace tyndall::translucency {
namespace {

constexpr float kWidest = 3.73f;  ///< tan of 75 degrees
/// Where the perspective begins, over the solid's radius.
constexpr float kNear = 0.02f;

void turn_toward(ScatterView& view, glm::vec3 direction) {
    view.forward = direction;
    const glm::vec3 aside = std::abs(direction.y) < 0.9f ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0);
    view.right = glm::normalize(glm::cross(direction, aside));
    view.up = glm::cross(view.right, direction);
}

}  // namespace

ScatterView scatter_view(const Light& light, const Surface& surface, int size) {
    ScatterView view;
    const Bounds& box = surface.mesh->mesh.bounds;
    const glm::vec3 middle(surface.transform * glm::vec4(0.5f * (box.low + box.high), 1.0f));
    view.perspective = light.kind != LightKind::directional;
    const glm::vec3 place(light.transform[3]);
    view.origin = view.perspective ? place : middle;
    const glm::vec3 way = middle - place;
    view.depth = view.perspective ? glm::length(way) : 0.0f;
    turn_toward(view, view.perspective && view.depth > 0.0f ? way / view.depth
                                                            : -glm::normalize(glm::vec3(light.transform[2])));
    view.half = 0.0f;
    for (int i = 0; i < 8; ++i) {
        const glm::vec3 corner((i & 1) != 0 ? box.high.x : box.low.x, (i & 2) != 0 ? box.high.y : box.low.y,
                               (i & 4) != 0 ? box.high.z : box.low.z);
        const glm::vec3 p = glm::vec3(surface.transform * glm::vec4(corner, 1.0f)) - view.origin;
        const float z = glm::dot(p, view.forward);
        const float aside = std::max(std::abs(glm::dot(p, view.right)), std::abs(glm::dot(p, view.up)));
        view.reach = std::max(view.reach, std::abs(z - view.depth));
        view.half = std::max(view.half, !view.perspective ? aside : z > 0.0f ? aside / z : kWidest);
    }
    view.half = std::max(view.half, 1e-6f) * (1.0f + 4.0f / static_cast<float>(size));
    if (view.perspective) view.half = std::min(view.half, kWidest);
    return view;
}

glm::mat4 ScatterView::clip_from_world() const {
    const float extent = std::max(1.01f * reach, 1e-6f), scale = 1.0f / half;
    const glm::vec3 rows[3] = {right, up, forward};
    glm::mat4 clip(0.0f);
    for (int i = 0; i < 3; ++i) {
        clip[i][0] = scale * rows[0][i];
        clip[i][1] = scale * rows[1][i];
        clip[i][2] = perspective ? 0.0f : -0.5f / extent * rows[2][i];
        clip[i][3] = perspective ? rows[2][i] : 0.0f;
    }
    clip[3] = glm::vec4(-scale * glm::dot(right, origin), -scale * glm::dot(up, origin),
                        perspective ? kNear * extent : 0.5f + 0.5f / extent * glm::dot(forward, origin),
                        perspective ? -glm::dot(forward, origin) : 1.0f);
    return clip;
}

}  // namespace tyndall::translucency
