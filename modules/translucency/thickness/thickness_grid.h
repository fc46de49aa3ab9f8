#pragma once
/// How thick a body is about each place of its surface.

#include <glm/vec3.hpp>
#include <vector>

#include "geometry/mesh.h"

namespace tyndall::translucency {

/// Thickness near the surface, in voxels; of the mesh's unit.
struct ThicknessGrid {
    Bounds box;
    glm::ivec3 size{0};
    std::vector<float> thickness;  ///< x first; 0 away from the surface
    float mean = 0.0f;

    [[nodiscard]] bool empty() const { return thickness.empty(); }
};

/// From points all over the surface rays go inward, spread as the cosine is, to where they leave the body; the mean of
/// their depths below the surface is the thickness there: a slab's own, a sphere's radius (Barre-Brisebois & Bouchard
/// 2011 bake inverted ambient occlusion, which has no length). Rays that leave through a hole count as the body's whole
/// size. `resolution` voxels along the longest side. Empty for a mesh without area.
[[nodiscard]] ThicknessGrid make_thickness_grid(const Mesh& mesh, int resolution);

}  // namespace tyndall::translucency
