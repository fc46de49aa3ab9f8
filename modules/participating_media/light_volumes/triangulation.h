#pragma once
/// A square grid of heights as few triangles without cracks.

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace tyndall::participating_media {

/// Triangles over a grid of (quads + 1)^2 points, row by row; clockwise where columns run right and rows up.
struct Triangulation {
    std::vector<uint32_t> triangles;  ///< three points each
    std::vector<uint32_t> border;     ///< the points on the border that triangles use, counter-clockwise from the first
};

/// Splits right-angled triangles at the middle of their longest side until the surface is within `tolerance` of the
/// heights: neighbours always share whole edges (Evans, Kirkpatrick & Townsend 2001: right-triangulated irregular
/// networks). `quads` is a power of two. `difference` says how far a height, interpolated between those of two points,
/// is from the third's. A negative tolerance splits all.
[[nodiscard]] Triangulation triangulate(std::span<const float> heights, int quads, float tolerance,
                                        const std::function<float(float, float)>& difference);

}  // namespace tyndall::participating_media
