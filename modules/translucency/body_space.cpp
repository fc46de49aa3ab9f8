#include "body_space.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

namespace tyndall::translucency {
namespace {

/// Halves a triangle across its longest edge until no edge is longer than `longest`. Neighbours cut an edge they share
/// at the same place.
void cut(std::array<uint32_t, 3> corners, float longest, Mesh& into) {
    const auto edge = [&](size_t i) {
        return glm::distance(into.positions[corners[i]], into.positions[corners[(i + 1) % 3]]);
    };
    size_t i = 0;
    for (size_t other = 1; other < 3; ++other)
        if (edge(other) > edge(i)) i = other;
    if (!(edge(i) > longest)) {
        into.indices.insert(into.indices.end(), corners.begin(), corners.end());
        return;
    }
    const uint32_t a = corners[i], b = corners[(i + 1) % 3], c = corners[(i + 2) % 3];
    const auto middle = uint32_t(into.positions.size());
    into.positions.push_back(0.5f * (into.positions[a] + into.positions[b]));
    into.normals.push_back(0.5f * (into.normals[a] + into.normals[b]));
    cut({a, middle, c}, longest, into);
    cut({middle, b, c}, longest, into);
}

}  // namespace

glm::vec3 shape_of(const glm::mat4& transform) {
    const glm::vec3 scale(glm::length(transform[0]), glm::length(transform[1]), glm::length(transform[2]));
    const glm::vec3 steps = glm::round(50.0f * glm::log(scale / std::max({scale.x, scale.y, scale.z})));
    return glm::exp(steps / 50.0f);
}

ShapeKey shape_key(const Surface& surface) {
    const glm::vec3 shape = shape_of(surface.transform);
    return {surface.mesh->id, shape.x, shape.y, shape.z};
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

Mesh cut_mesh(const Mesh& mesh, float longest) {
    Mesh made;
    made.positions = mesh.positions;
    made.normals = mesh.normals;
    if (made.normals.empty()) made.normals.resize(mesh.positions.size(), glm::vec3(0.0f));
    made.bounds = mesh.bounds;
    for (size_t t = 0; t < mesh.triangle_count(); ++t)
        cut({mesh.indices[3 * t], mesh.indices[3 * t + 1], mesh.indices[3 * t + 2]}, longest, made);
    return made;
}

glm::mat4 world_from_stretched(const Surface& surface, const glm::vec3& shape) {
    return surface.transform * glm::scale(glm::mat4(1.0f), 1.0f / shape);
}

float metres_of_unit(const glm::mat4& world_from_stretched) {
    return std::cbrt(std::abs(glm::determinant(glm::mat3(world_from_stretched))));
}

glm::mat3 area_matrix(const glm::mat4& transform) {
    const glm::mat3 m(transform);
    return {glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1])};
}

}  // namespace tyndall::translucency
