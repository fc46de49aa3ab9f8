#pragma once
// Meshes with UVs that are known.

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>

#include "geometry/mesh.h"

namespace tyndall::skin {

inline void add_quad(Mesh& mesh, const std::array<glm::vec3, 4>& corners, const std::array<glm::vec2, 4>& uvs) {
    const auto first = uint32_t(mesh.positions.size());
    const glm::vec3 normal = glm::normalize(glm::cross(corners[1] - corners[0], corners[2] - corners[0]));
    for (size_t i = 0; i < 4; ++i) {
        mesh.positions.push_back(corners[i]);
        mesh.normals.push_back(normal);
        mesh.uv0.push_back(uvs[i]);
    }
    for (const uint32_t i : {0u, 1u, 2u, 0u, 2u, 3u}) mesh.indices.push_back(first + i);
    mesh.bounds = bounds_of(mesh.positions);
}

/// Faces +Z, u along +X from `low` on, v along -Y; metres.
inline Mesh sheet(float width, float height, const glm::vec2& low, const glm::vec2& high) {
    Mesh mesh;
    const float x = 0.5f * width, y = 0.5f * height;
    add_quad(mesh, {{{-x, -y, 0}, {x, -y, 0}, {x, y, 0}, {-x, y, 0}}},
             {{{low.x, high.y}, {high.x, high.y}, {high.x, low.y}, {low.x, low.y}}});
    return mesh;
}

/// A cube of side 1 whose faces have room between them in the UVs and are turned in turns.
inline Mesh unwrapped_cube() {
    Mesh mesh;
    for (size_t face = 0; face < 6; ++face) {
        const glm::vec3 axis(face / 2 == 0, face / 2 == 1, face / 2 == 2), n = (face % 2 == 0 ? 0.5f : -0.5f) * axis;
        const glm::vec3 a = 0.5f * glm::vec3(axis.y, axis.z, axis.x), b = glm::cross(2.0f * n, a);
        std::array<glm::vec2, 4> uvs{{{0.0f, 0.0f}, {0.27f, 0.0f}, {0.27f, 0.27f}, {0.0f, 0.27f}}};
        std::rotate(uvs.begin(), uvs.begin() + std::ptrdiff_t(face % 4), uvs.end());
        for (glm::vec2& uv : uvs) uv += glm::vec2(0.36f * float(face % 3), 0.36f * float(face / 3));
        add_quad(mesh, {{n - a - b, n + a - b, n + a + b, n - a + b}}, uvs);
    }
    return mesh;
}

}  // namespace tyndall::skin
