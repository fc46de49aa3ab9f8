#include "scene/primitives.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tyndall {
namespace {

constexpr float kPi = std::numbers::pi_v<float>;

void add_vertex(Mesh& mesh, const glm::vec3& position, const glm::vec3& normal, const glm::vec3& tangent,
                const glm::vec2& uv, float handedness = 1.0f) {
    mesh.positions.push_back(position);
    mesh.normals.push_back(normal);
    mesh.tangents.emplace_back(tangent, handedness);
    mesh.uv0.push_back(uv);
}

/// Two triangles a row, for a grid of (columns + 1) x (rows + 1) vertices whose rows run counter-clockwise from
/// outside, the next row above.
void add_grid(Mesh& mesh, uint32_t first, uint32_t columns, uint32_t rows) {
    for (uint32_t row = 0; row < rows; ++row)
        for (uint32_t column = 0; column < columns; ++column) {
            const uint32_t low = first + row * (columns + 1) + column;
            const uint32_t high = low + columns + 1;
            for (const uint32_t index : {low, low + 1, high + 1, low, high + 1, high}) mesh.indices.push_back(index);
        }
}

uint32_t vertex_count(const Mesh& mesh) {
    return static_cast<uint32_t>(mesh.positions.size());
}

/// One square face of side 1 around `centre`: `right` x `up` is its normal.
void add_square(Mesh& mesh, const glm::vec3& centre, const glm::vec3& right, const glm::vec3& up) {
    const uint32_t first = vertex_count(mesh);
    const glm::vec3 normal = glm::cross(right, up);
    for (const float y : {0.0f, 1.0f})
        for (const float x : {0.0f, 1.0f})
            add_vertex(mesh, centre + (x - 0.5f) * right + (y - 0.5f) * up, normal, right, {x, 1.0f - y});
    add_grid(mesh, first, 1, 1);
}

glm::vec3 around(float u) {
    const float angle = 2.0f * kPi * (u - std::floor(u));  // the seam closes exactly
    return {std::sin(angle), 0.0f, std::cos(angle)};
}
glm::vec3 along(float u) {
    const float angle = 2.0f * kPi * (u - std::floor(u));
    return {std::cos(angle), 0.0f, -std::sin(angle)};
}

void add_sphere(Mesh& mesh, uint32_t segments) {
    const uint32_t rings = std::max(2u, segments / 2);
    for (uint32_t ring = 0; ring <= rings; ++ring)
        for (uint32_t column = 0; column <= segments; ++column) {
            const float u = static_cast<float>(column) / static_cast<float>(segments);
            const float v = static_cast<float>(ring) / static_cast<float>(rings);
            const float latitude = kPi * (v - 0.5f);
            const bool pole = ring == 0 || ring == rings;
            const glm::vec3 normal = pole ? glm::vec3(0.0f, ring == 0 ? -1.0f : 1.0f, 0.0f)
                                          : around(u) * std::cos(latitude) + glm::vec3(0.0f, std::sin(latitude), 0.0f);
            add_vertex(mesh, 0.5f * normal, normal, along(u), {u, 1.0f - v});
        }
    add_grid(mesh, 0, segments, rings);
    // A quad at a pole has no lower or upper edge: its second or first triangle is none.
    std::vector<uint32_t> proper;
    for (size_t i = 0; i < mesh.indices.size(); i += 3) {
        const glm::vec3& a = mesh.positions[mesh.indices[i]];
        const glm::vec3& b = mesh.positions[mesh.indices[i + 1]];
        const glm::vec3& c = mesh.positions[mesh.indices[i + 2]];
        if (a != b && b != c && c != a)
            proper.insert(proper.end(), {mesh.indices[i], mesh.indices[i + 1], mesh.indices[i + 2]});
    }
    mesh.indices = std::move(proper);
}

void add_disc(Mesh& mesh, uint32_t segments, float side) {
    const uint32_t centre = vertex_count(mesh);
    const glm::vec3 normal(0.0f, side, 0.0f);
    const auto vertex = [&](const glm::vec3& p) {
        add_vertex(mesh, glm::vec3(p.x, 0.5f * side, p.z), normal, {1.0f, 0.0f, 0.0f}, {p.x + 0.5f, 0.5f + side * p.z});
    };
    vertex({});
    for (uint32_t i = 0; i <= segments; ++i)
        vertex(0.5f * around(static_cast<float>(i) / static_cast<float>(segments)));
    for (uint32_t i = 1; i <= segments; ++i) {
        mesh.indices.push_back(centre);
        mesh.indices.push_back(centre + (side > 0.0f ? i : i + 1));
        mesh.indices.push_back(centre + (side > 0.0f ? i + 1 : i));
    }
}

void add_cylinder(Mesh& mesh, uint32_t segments) {
    for (const float y : {0.0f, 1.0f})
        for (uint32_t column = 0; column <= segments; ++column) {
            const float u = static_cast<float>(column) / static_cast<float>(segments);
            add_vertex(mesh, 0.5f * around(u) + glm::vec3(0.0f, y - 0.5f, 0.0f), around(u), along(u), {u, 1.0f - y});
        }
    add_grid(mesh, 0, segments, 1);
    add_disc(mesh, segments, 1.0f);
    add_disc(mesh, segments, -1.0f);
}

void add_box(Mesh& mesh) {
    const glm::vec3 x(1.0f, 0.0f, 0.0f);
    const glm::vec3 y(0.0f, 1.0f, 0.0f);
    const glm::vec3 z(0.0f, 0.0f, 1.0f);
    add_square(mesh, 0.5f * z, x, y);
    add_square(mesh, -0.5f * z, -x, y);
    add_square(mesh, 0.5f * x, -z, y);
    add_square(mesh, -0.5f * x, z, y);
    add_square(mesh, 0.5f * y, x, -z);
    add_square(mesh, -0.5f * y, x, z);
}

}  // namespace

Mesh make_primitive(Primitive shape, int tessellation) {
    Mesh mesh;
    const auto segments = static_cast<uint32_t>(std::clamp(tessellation, 3, 512));
    switch (shape) {
        case Primitive::none:
            break;
        case Primitive::sphere:
            add_sphere(mesh, segments);
            break;
        case Primitive::box:
            add_box(mesh);
            break;
        case Primitive::plane:
            add_square(mesh, {}, {1.0f, 0.0f, 0.0f}, {0.0f, 0.0f, -1.0f});
            break;
        case Primitive::cylinder:
            add_cylinder(mesh, segments);
            break;
    }
    mesh.bounds = bounds_of(mesh.positions);
    return mesh;
}

}  // namespace tyndall
