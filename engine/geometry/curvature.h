#pragma once
/// How much a surface bends.

#include "geometry/mesh.h"

namespace tyndall {

/// Makes the curvatures anew: the mean over directions of how fast the normal turns, positive where the surface is
/// convex, 1 over the mesh's unit (a sphere of radius r: 1 / r). Along each edge (p_j - p_i) . (n_j - n_i) /
/// |p_j - p_i|^2, averaged over the edges of a place, then smoothed over the surface as by a Gaussian whose standard
/// deviation is `smoothing` (the mesh's unit). Vertices in the same place have the same. Throws Error when the mesh has
/// no normals.
void compute_curvatures(Mesh& mesh, float smoothing);

}  // namespace tyndall
