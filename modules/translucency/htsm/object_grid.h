#pragma once
/// A solid as a grid of voxels: what of each lies inside the mesh, and how dense it is there.

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "geometry/mesh.h"
#include "scene/density.h"

namespace tyndall::translucency {

/// Where so much of a voxel is inside, its density counts whole: the mesh and the shadow map say the borders to more
/// than a voxel, and the grid must not thin what lies at them. As in shaders/htsm/object.glsl.
constexpr float kInsideAll = 0.5f;

/// Values lie at voxel centres, x fastest, then y, then z.
struct ObjectGrid {
    Bounds box;                  ///< of the mesh's space: its bounds and a voxel around them
    glm::ivec3 size{0};          ///< voxels; 0 = the mesh encloses nothing
    std::vector<float> inside;   ///< share of the voxel that is inside, 0..1
    std::vector<float> density;  ///< of the field at the voxel's centre, also outside of the mesh
    float open_share = 0.0f;     ///< of the lines through the mesh, those that entered and did not leave again

    [[nodiscard]] size_t count() const { return size_t(size.x) * size_t(size.y) * size_t(size.z); }
    [[nodiscard]] glm::vec3 voxel() const { return box.size() / glm::vec3(glm::max(size, glm::ivec3(1))); }
    [[nodiscard]] glm::vec3 centre(int x, int y, int z) const {
        return box.low + (glm::vec3(x, y, z) + 0.5f) * voxel();
    }
    /// From the mesh's space to [0, 1]^3 over the box.
    [[nodiscard]] glm::mat4 to_unit_box() const;
};

/// A grid of `resolution` voxels along the longest side of the mesh's bounds, cubes where they can be, with `inside`
/// filled: exact along lines in x, four by four of which cross a voxel. What is inside is told by the winding number,
/// so parts may overlap. On a line that does not leave a mesh again that it entered (a hole), all between its first and
/// its last crossing counts as inside.
[[nodiscard]] ObjectGrid make_object_grid(const Mesh& mesh, int resolution);

/// Fills `density`.
void fill_density(ObjectGrid& grid, const DensityEvaluator& density);

/// Whether both fields are the same everywhere, now and at all times.
[[nodiscard]] bool same_density(const DensityField& a, const DensityField& b);
/// Whether the field depends on where in the world the object is, or when it is looked at.
[[nodiscard]] bool moves_with_world(const DensityField& field);

}  // namespace tyndall::translucency
