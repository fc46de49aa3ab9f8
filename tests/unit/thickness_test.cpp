// How thick bodies are below their surfaces: slabs and balls.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <numbers>

#include "geometry/thickness.h"
#include "skin_meshes.h"

namespace tyndall {
namespace {

/// Longitude and latitude; the first and the last column of vertices are in the same places.
Mesh ball(float radius, int rows) {
    constexpr float kPi = std::numbers::pi_v<float>;
    Mesh mesh;
    const int columns = 2 * rows;
    for (int j = 0; j <= rows; ++j)
        for (int i = 0; i <= columns; ++i) {
            const float up = kPi * float(j) / float(rows), around = 2.0f * kPi * float(i % columns) / float(columns);
            const glm::vec3 n(std::sin(up) * std::cos(around), std::cos(up), std::sin(up) * std::sin(around));
            mesh.positions.push_back(radius * n);
            mesh.normals.push_back(n);
        }
    const auto at = [&](int j, int i) { return uint32_t(j * (columns + 1) + i); };
    for (int j = 0; j < rows; ++j)
        for (int i = 0; i < columns; ++i)
            for (const uint32_t index :
                 {at(j, i), at(j, i + 1), at(j + 1, i), at(j + 1, i), at(j, i + 1), at(j + 1, i + 1)})
                mesh.indices.push_back(index);
    mesh.bounds = bounds_of(mesh.positions);
    return mesh;
}

TEST(Thickness, ASlabsIsItsOwn) {
    Mesh slab = skin::unwrapped_cube();
    for (glm::vec3& position : slab.positions) position.z *= 0.01f;
    slab.bounds = bounds_of(slab.positions);
    const std::vector<float> thickness = vertex_thicknesses(slab);
    ASSERT_EQ(thickness.size(), slab.positions.size());
    for (size_t i = 0; i < thickness.size(); ++i) {
        if (std::abs(slab.normals[i].z) < 0.5f) continue;
        EXPECT_NEAR(thickness[i], 0.01f, 1e-4f);
    }
    std::printf("a slab of 0.01: %.5f\n", double(thickness.back()));
}

TEST(Thickness, ABallsIsItsRadius) {
    const int rows = 24;
    const Mesh mesh = ball(2.0f, rows);
    const std::vector<float> thickness = vertex_thicknesses(mesh);
    ASSERT_EQ(thickness.size(), mesh.positions.size());
    float least = 10.0f, most = 0.0f;
    for (const float t : thickness) {
        least = std::min(least, t);
        most = std::max(most, t);
    }
    std::printf("a ball of radius 2: %.4f to %.4f\n", double(least), double(most));
    EXPECT_GT(least, 1.98f);
    EXPECT_LT(most, 2.01f);
    // no seam
    for (int j = 1; j < rows; ++j)
        EXPECT_EQ(thickness[size_t(j * (2 * rows + 1))], thickness[size_t(j * (2 * rows + 1) + 2 * rows)]);
}

TEST(Thickness, NothingHasNone) {
    EXPECT_TRUE(vertex_thicknesses({}).empty());
    Mesh flat = skin::unwrapped_cube();
    for (glm::vec3& position : flat.positions) position = glm::vec3(0.0f);
    flat.bounds = bounds_of(flat.positions);
    EXPECT_TRUE(vertex_thicknesses(flat).empty());
}

}  // namespace
}  // namespace tyndall
