#pragma once
/// The space in which techniques keep what they know of a mesh: the mesh's own, its axes stretched as its transform
/// stretches them, so that the rest of the transform is a turn, a move and one scale.

#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <tuple>

#include "scene/render_scene.h"

namespace tyndall::translucency {

/// How a transform stretches the mesh's axes, over the most, in steps of a fiftieth so that little changes keep what
/// was made.
[[nodiscard]] glm::vec3 shape_of(const glm::mat4& transform);
/// A surface's mesh and shape: what surfaces that differ by the rest alone can share things by.
using ShapeKey = std::tuple<uint64_t, float, float, float>;
[[nodiscard]] ShapeKey shape_key(const Surface& surface);
/// The mesh with its axes stretched.
[[nodiscard]] Mesh stretched(const Mesh& mesh, const glm::vec3& shape);
/// Places, normals and triangles of a mesh, those with edges longer than `longest` halved until there are none.
[[nodiscard]] Mesh cut_mesh(const Mesh& mesh, float longest);
[[nodiscard]] glm::mat4 world_from_stretched(const Surface& surface, const glm::vec3& shape);
/// Metres of a unit of that space.
[[nodiscard]] float metres_of_unit(const glm::mat4& world_from_stretched);
/// Cofactors: they turn an area's vector as the matrix turns its sides.
[[nodiscard]] glm::mat3 area_matrix(const glm::mat4& transform);

}  // namespace tyndall::translucency
