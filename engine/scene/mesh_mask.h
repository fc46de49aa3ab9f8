#pragma once
/// The inside of closed meshes as volumes.

#include <string>

#include "geometry/mesh.h"
#include "image/volume.h"

namespace tyndall {

/// Cubic voxels, `resolution` of them along the longest edge of the mesh's bounds: 1 inside, 0 outside, in between over
/// the width of a voxel at the surface. The volume's low_m and voxel_m are in the mesh's space. Throws Error, naming
/// `source`, for a mesh without triangles, without an extent, or with open edges: it has no inside.
[[nodiscard]] Volume voxelised(const Mesh& mesh, int resolution, const std::string& source);

/// How many edges do not belong to an even number of triangles, where vertices in the same place are one: 0 for a
/// closed mesh.
[[nodiscard]] size_t open_edges(const Mesh& mesh);

}  // namespace tyndall
