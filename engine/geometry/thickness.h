#pragma once
/// How thick a body is below its surface.

#include <vector>

#include "geometry/ray_mesh.h"

namespace tyndall {

/// Rays from below a mesh's surface into the body, spread as the cosine to the inward normal is.
class InwardRays {
 public:
    /// `count` rays a place.
    InwardRays(const Mesh& mesh, int count);

    /// The mean depth below the surface at which the rays leave the body, in the mesh's unit: a slab's thickness, a
    /// sphere's radius (Barre-Brisebois & Bouchard 2011 bake inverted ambient occlusion, which has no length). What
    /// leaves through a hole has gone as far as the body is large. `turn`: of the rays about the normal, radians. Any
    /// thread.
    [[nodiscard]] float thickness(const glm::vec3& position, const glm::vec3& normal, float turn = 0.0f) const;

 private:
    RayMesh triangles_;
    std::vector<glm::vec3> directions_;
    float body_size_ = 0.0f;
};

/// That of each vertex, in the mesh's unit: the mean over its corner of each triangle, by area. Vertices in the same
/// place with the same normal have the same. 0.1 to 0.5 s for a head; deterministic. Empty for a mesh without area or
/// normals.
[[nodiscard]] std::vector<float> vertex_thicknesses(const Mesh& mesh);

}  // namespace tyndall
