#include "light_view.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_inverse.hpp>
#include <limits>

namespace tyndall::translucency {
namespace {

/// The nearest place over the farthest: nearer to a light, its window holds not all of an object.
constexpr float kNearest = 0.02f;
constexpr float kWidest = 3.73f;  ///< tan of 75 degrees

/// `LightView` of shaders/light_view.glsl.
struct Block {
    glm::mat4 view_from_world;
    glm::vec4 window;
    glm::vec4 perspective_texel;
};

/// Rigid, looking from `eye` along `forward`, which is the view's +z: a mirrored space, so that faces turn as they do
/// in a camera's picture.
glm::mat4 looking(const glm::vec3& eye, const glm::vec3& forward, const glm::vec3& about_right) {
    const glm::vec3 side = about_right - glm::dot(about_right, forward) * forward;
    const glm::vec3 other = glm::cross(forward, std::abs(forward.x) < 0.8f ? glm::vec3(1, 0, 0) : glm::vec3(0, 1, 0));
    const glm::vec3 right = glm::normalize(glm::dot(side, side) > 1e-4f ? side : other);
    const glm::vec3 up = glm::cross(right, forward);
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

/// What the vertices span in the window, and in z.
Bounds spanned(const LightView& view, const Mesh& mesh, const glm::mat4& transform) {
    const glm::mat4 view_from_local = view.view_from_world * transform;
    Bounds span{glm::vec3(std::numeric_limits<float>::infinity()), glm::vec3(-std::numeric_limits<float>::infinity())};
    for (const glm::vec3& position : mesh.positions) {
        glm::vec3 at(view_from_local * glm::vec4(position, 1.0f));
        if (view.perspective)
            at = glm::vec3(glm::clamp(glm::vec2(at) / std::max(at.z, 1e-6f), -kWidest, kWidest), at.z);
        span.low = glm::min(span.low, at);
        span.high = glm::max(span.high, at);
    }
    return span;
}

}  // namespace

LightView light_view(const Light& light, const Mesh& mesh, const glm::mat4& transform, int texels) {
    LightView view;
    const glm::vec3 middle(transform * glm::vec4(mesh.bounds.centre(), 1.0f)), place(light.transform[3]);
    view.perspective = light.kind != LightKind::directional;
    const glm::vec3 way = middle - place, travel = -glm::normalize(glm::vec3(light.transform[2]));
    view.middle_z = view.perspective ? glm::length(way) : 0.0f;
    view.view_from_world = looking(view.perspective ? place : middle,
                                   view.middle_z > 0.0f ? way / view.middle_z : travel, glm::vec3(light.transform[0]));
    const Bounds span = spanned(view, mesh, transform);
    const float extent = std::max(span.high.x - span.low.x, span.high.y - span.low.y);
    if (mesh.positions.empty() || !(extent > 0.0f) || !std::isfinite(extent)) return view;
    view.whole = !view.perspective || span.low.z >= kNearest * span.high.z;
    view.size = extent * float(texels) / float(texels - 4);
    view.low = 0.5f * (glm::vec2(span.low) + glm::vec2(span.high)) - 0.5f * view.size;
    const float margin = 0.01f * view.width_m();
    float near_z = span.low.z - margin;
    if (view.perspective) near_z = view.whole ? 0.5f * span.low.z : kNearest * (span.high.z - span.low.z);
    view.clip_from_world = clip_of(view, near_z, span.high.z + margin) * view.view_from_world;
    return view;
}

void LightViewBlock::update(const LightView& view, int texels) {
    const float texel = std::max(view.width_m(), 1e-9f) / float(texels);
    const Block block{view.view_from_world, glm::vec4(view.low, view.size, view.middle_z),
                      glm::vec4(view.perspective ? 1.0f : 0.0f, std::log2(texel), 0.0f, 0.0f)};
    if (buffer_.name() == 0) buffer_ = gpu::Buffer(sizeof block, nullptr, "translucency.light_view");
    buffer_.update(0, sizeof block, &block);
}

void draw_in(const LightView& view, const gpu::Program& program, GpuScene& scene, const Surface& surface) {
    program.set("world_from_local", surface.transform);
    program.set("normal_from_local", glm::inverseTranspose(glm::mat3(surface.transform)));
    program.set("clip_from_world", view.clip_from_world);
    scene.draw_mesh(*surface.mesh);
}

}  // namespace tyndall::translucency
