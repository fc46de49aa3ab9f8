#pragma once
/// From where lights look at the scene for their shadow maps. Needs no GL.

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <vector>

#include "scene/render_scene.h"

namespace tyndall {

/// One look at the scene: a square of a page of the shadow texture.
struct ShadowView {
    size_t light = 0;
    glm::mat4 clip_from_world{1.0f};  ///< reversed-Z
    glm::vec3 eye{0.0f};              ///< the light, or for directional lights a point toward it, outside of the scene
    bool perspective = false;
    bool fades = false;    ///< a cascade beyond whose border the scene goes on
    float texel_m = 0.0f;  ///< metres a texel covers; perspective: at 1 m from the light
    int size = 0;          ///< texels on a side, a power of two
    int page = 0;          ///< layer of the texture
    glm::ivec2 corner{0};  ///< lowest texel in the page
};

/// What shadow maps may cost.
struct ShadowLimits {
    int max_size = 4096;            ///< texels on a side
    size_t max_bytes = 192u << 20;  ///< of all pages
};

/// All views of a frame.
struct ShadowPlan {
    std::vector<ShadowView> views;  ///< those of one light one after the other
    int page_size = 1;
    int pages = 1;
    bool reduced = false;  ///< some views are smaller than asked for, to keep within the limits
};

/// Views for every light that asks for shadows. Spots: one; spots wider than 75 degrees and points: six, in the order
/// +X -X +Y -Y +Z -Z of world axes, a little wider than 90 degrees so that filters need no neighbour; directional
/// lights: cascades, nearest first, around what the camera sees (`tan_half_fov` horizontal, vertical).
///
/// Cascades keep still: they are as large as the sphere around their part of the camera's frustum and move in steps of
/// whole texels, an eighth of their width, so that most frames can keep their maps. One that would be larger than the
/// whole scene (`bounds`) takes the scene instead, stays there, and is the last.
[[nodiscard]] ShadowPlan plan_shadows(const RenderScene& scene, const Bounds& bounds, glm::vec2 tan_half_fov,
                                      const ShadowLimits& limits = {});

}  // namespace tyndall
