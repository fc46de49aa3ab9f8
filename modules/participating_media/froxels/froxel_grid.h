#pragma once
/// Where the froxels are: a grid over the picture and over depth.

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <vector>

#include "gpu/gpu.h"
#include "media_settings.h"
#include "render/frame.h"
#include "scene/render_scene.h"
#include "solver_plan.h"

namespace tyndall::participating_media {

/// Columns over the picture, slices over the depth along the eye's axis. Slice k of n begins at
/// `begin + spread (exp(growth k / n) - 1)` metres: even near `begin`, of a thickness in proportion to depth far off.
struct FroxelGrid {
    glm::ivec3 size{1};
    float begin_m = 0.0f;
    float end_m = 1.0f;
    float spread_m = 1.0f;
    float growth = 1.0f;
    bool complete = true;  ///< no medium of the froxels' goes on beyond the end

    /// begin, spread, growth, end, as shaders/froxels/grid.glsl wants it.
    [[nodiscard]] glm::vec4 depths() const { return {begin_m, spread_m, growth, end_m}; }
    /// Slice that holds this depth; may lie outside of the grid.
    [[nodiscard]] int slice(float metres) const;
};

/// A grid that encloses the media of these terms as far as the settings' range.
[[nodiscard]] FroxelGrid fit_grid(const FroxelSettings& settings, const Frame& frame, const std::vector<Medium>& media,
                                  const std::vector<Term>& terms);

/// Froxels from `low` on.
struct FroxelBox {
    glm::ivec3 low{0};
    glm::ivec3 size{0};
    [[nodiscard]] bool empty() const { return size.x <= 0 || size.y <= 0 || size.z <= 0; }
};

/// Encloses what a light with a range can reach, or is the whole grid.
[[nodiscard]] FroxelBox light_box(const FroxelGrid& grid, const Light& light, const FrameBlock& block);

}  // namespace tyndall::participating_media
