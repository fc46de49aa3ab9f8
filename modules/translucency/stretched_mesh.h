#pragma once
/// What is made once for a mesh and for how its axes are stretched.

#include <glm/mat4x4.hpp>

#include "geometry/mesh.h"

namespace tyndall::translucency {

/// How a transform stretches the mesh's axes, over the most, in steps of a fiftieth so that little changes are none.
[[nodiscard]] glm::vec3 shape_of(const glm::mat4& transform);

/// The mesh with its axes stretched: positions, normals and triangles.
[[nodiscard]] Mesh stretched(const Mesh& mesh, const glm::vec3& shape);

}  // namespace tyndall::translucency
