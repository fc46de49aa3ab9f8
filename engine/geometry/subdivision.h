#pragma once
/// Catmull-Clark surfaces through OpenSubdiv.

#include <span>

#include "geometry/polygons.h"

namespace tyndall {

/// An edge of the control mesh that stays sharp.
struct Crease {
    std::uint32_t first = 0;  ///< index of a position
    std::uint32_t second = 0;
    float sharpness = 10.0f;  ///< 0 = smooth; 10 and above: infinitely sharp
};

/// The Catmull-Clark surface of a control mesh, refined `levels` times (0..8) and moved onto the limit surface; normals
/// are those of the limit surface. Boundaries stay, corners are kept; UVs keep their seams. Each level has four times
/// the faces; tangents are not made. Throws Error for a control mesh that is no surface, a crease that is no edge, or
/// more than 8 million faces.
[[nodiscard]] Mesh subdivide(const PolygonMesh& control, int levels, std::span<const Crease> creases = {});

}  // namespace tyndall
