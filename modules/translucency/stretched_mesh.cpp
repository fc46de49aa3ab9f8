#include "stretched_mesh.h"

#include <algorithm>
#include <glm/exponential.hpp>
#include <glm/geometric.hpp>

namespace tyndall::translucency {

glm::vec3 shape_of(const glm::mat4& transform) {
    const glm::vec3 scale(glm::length(transform[0]), glm::length(transform[1]), glm::length(transform[2]));
    const glm::vec3 steps = glm::round(50.0f * glm::log(scale / std::max({scale.x, scale.y, scale.z})));
    return glm::exp(steps / 50.0f);
}

Mesh stretched(const Mesh& mesh, const glm::vec3& shape) {
    Mesh made;
    made.positions = mesh.positions;
    made.normals = mesh.normals;
    made.indices = mesh.indices;
    for (glm::vec3& position : made.positions) position *= shape;
    for (glm::vec3& normal : made.normals) normal = glm::normalize(normal / shape);
    made.bounds = bounds_of(made.positions);
    return made;
}

}  // namespace tyndall::translucency
