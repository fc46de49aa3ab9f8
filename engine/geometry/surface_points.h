#pragma once
/// Points that stand for a mesh's surface in sums over it.

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "geometry/mesh.h"

namespace tyndall {

/// A point of the surface and the piece of it that it stands for.
struct SurfacePoint {
    glm::vec3 position{0.0f};  ///< on the surface, the middle of its piece as near as can be
    float area = 0.0f;         ///< of the piece, in the square of the mesh's unit
    glm::vec3 normal{0.0f};    ///< unit, the mesh's own where it has normals
};

/// 2^levels points that share the surface in equal pieces, in the order of a balanced tree: those from i 2^k to
/// (i + 1) 2^k lie together for every i and k. The areas' sum is the surface's.
///
/// The surface is cut into fragments much smaller than a piece; a tree halves their area along the axis in which they
/// are spread most, until each leaf is a piece (stratified sampling: no clumps and no holes, and no noise in the
/// areas). Normals count as three axes more, so that the two sides of a thin sheet become pieces of their own.
/// Deterministic. Empty for a mesh without area.
[[nodiscard]] std::vector<SurfacePoint> sample_surface(const Mesh& mesh, int levels);

}  // namespace tyndall
