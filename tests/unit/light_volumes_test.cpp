// Shadow maps as meshes.

#include "light_volumes/shadow_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <map>

#include "light_volumes/triangulation.h"
#include "quadrature.h"

namespace tyndall::participating_media {
namespace {

constexpr int kSize = 64;

/// A spot at 4 m, looking down, its pyramid 90 degrees wide; infinite reversed-Z, near plane at 0.1 m.
ShadowView spot_view() {
    glm::mat4 clip(0.0f);
    clip[0][0] = clip[1][1] = 1.0f;
    clip[2][3] = -1.0f;
    clip[3][2] = 0.1f;
    const glm::vec3 eye(0.0f, 4.0f, 0.0f);
    return {.clip_from_world = clip * glm::lookAt(eye, glm::vec3(0.0f), glm::vec3(0.0f, 0.0f, -1.0f)),
            .eye = eye,
            .perspective = true,
            .size = kSize};
}

/// Reversed-Z depths of a floor at y = 0, with a plate of half width 0.5 m at y = 2 in the middle.
std::vector<float> depths_of_plate() {
    std::vector<float> depths(kSize * kSize, 0.1f / 4.0f);
    for (int y = 0; y < kSize; ++y)
        for (int x = 0; x < kSize; ++x)
            if (std::abs(2 * x + 1 - kSize) < kSize / 4 && std::abs(2 * y + 1 - kSize) < kSize / 4)
                depths[static_cast<size_t>(y * kSize + x)] = 0.1f / 2.0f;
    return depths;
}

/// Signed; positive when front faces look inward, as seen from a dark outside they look outward.
double volume_of(const ShadowMesh& mesh) {
    double sum = 0.0;
    for (size_t i = 0; i < mesh.indices.size(); i += 3) {
        const glm::dvec3 a(mesh.positions[mesh.indices[i]]), b(mesh.positions[mesh.indices[i + 1]]),
            c(mesh.positions[mesh.indices[i + 2]]);
        sum += glm::dot(a, glm::cross(b, c)) / 6.0;
    }
    return sum;
}

/// Every directed edge has its opposite.
bool closed(const ShadowMesh& mesh) {
    std::map<std::pair<uint32_t, uint32_t>, int> edges;
    for (size_t i = 0; i < mesh.indices.size(); i += 3)
        for (size_t k = 0; k < 3; ++k) ++edges[{mesh.indices[i + k], mesh.indices[i + (k + 1) % 3]}];
    return std::ranges::all_of(edges, [&](const auto& edge) {
        const auto opposite = edges.find({edge.first.second, edge.first.first});
        return opposite != edges.end() && opposite->second == edge.second;
    });
}

TEST(ShadowMesh, EnclosesTheLitSpaceOfASpot) {
    const double whole = std::pow(2.0 * 4.0, 2) * 4.0 / 3.0;
    for (const float tolerance : {0.0f, 0.01f, -1.0f}) {
        const ShadowMesh mesh = make_shadow_mesh(spot_view(), depths_of_plate(), 10.0f, {1, tolerance});
        EXPECT_TRUE(closed(mesh));
        // the plate takes away what lies between it and the floor: sides at a quarter of the width
        const double lost = std::pow(2.0 * 0.25 * 4.0, 2) * 4.0 / 3.0 * (1.0 - std::pow(0.5, 3));
        std::printf("%zu triangles, volume %.4f, expected %.4f\n", mesh.indices.size() / 3, volume_of(mesh),
                    whole - lost);
        EXPECT_NEAR(volume_of(mesh), whole - lost, 0.02 * whole);
    }
}

TEST(ShadowMesh, FacesOfACubeDoNotOverlap) {
    const std::vector<float> floor(kSize * kSize, 0.1f / 4.0f);
    const double e = (kSize - 6.0) / kSize;
    const ShadowMesh mesh = make_shadow_mesh(spot_view(), floor, 10.0f, {1, 0.0f}, true);
    EXPECT_NEAR(volume_of(mesh), std::pow(2.0 * e * 4.0, 2) * 4.0 / 3.0, 1e-3);
}

TEST(ShadowMesh, FlatGroundTakesFewTriangles) {
    const std::vector<float> floor(kSize * kSize, 0.1f / 4.0f);
    EXPECT_EQ(make_shadow_mesh(spot_view(), floor, 10.0f, {1, 0.001f}).indices.size() / 3, 2u + 4u);
    const ShadowMesh all = make_shadow_mesh(spot_view(), floor, 10.0f, {1, -1.0f});
    EXPECT_EQ(all.indices.size() / 3, 2u * kSize * kSize + 4u * kSize);
    EXPECT_TRUE(closed(all));
}

TEST(ShadowMesh, NothingInTheMapLiesAtTheReach) {
    const std::vector<float> nothing(kSize * kSize, 0.0f);
    const ShadowMesh mesh = make_shadow_mesh(spot_view(), nothing, 8.0f, {});
    for (const glm::vec3& p : mesh.positions)
        EXPECT_TRUE(p == glm::vec3(0.0f, 4.0f, 0.0f) || std::abs(p.y + 4.0f) < 1e-3f);
}

TEST(ShadowMesh, EnclosesTheDarkSpaceOfASun) {
    glm::mat4 clip(1.0f);  // looks down -Z over [-1, 1]^2, z from 0 (depth 1) to -10 (depth 0)
    clip[2][2] = 0.1f;
    clip[3][2] = 1.0f;
    const ShadowView view{.clip_from_world = clip, .size = kSize};
    std::vector<float> depths(kSize * kSize, 0.0f);
    for (int y = 0; y < kSize; ++y)
        for (int x = 0; x < kSize / 2; ++x) depths[static_cast<size_t>(y * kSize + x)] = 0.8f;  // a roof 2 m down
    for (const float tolerance : {0.01f, -1.0f}) {
        const ShadowMesh mesh = make_shadow_mesh(view, depths, 12.0f, {1, tolerance});
        EXPECT_TRUE(closed(mesh));
        // front faces look at the dark inside: turned inside out
        EXPECT_NEAR(-volume_of(mesh), 2.0 * 10.0, 0.02 * 20.0);
        EXPECT_NEAR(axis_distance(view, glm::vec3(0.3f, 0.2f, -4.0f)), 4.0f, 1e-4f);
    }
}

TEST(ShadowMesh, StaysWithinItsTolerance) {
    constexpr int kQuads = 32;
    std::vector<float> heights((kQuads + 1) * (kQuads + 1));
    for (int y = 0; y <= kQuads; ++y)
        for (int x = 0; x <= kQuads; ++x)
            heights[static_cast<size_t>(y * (kQuads + 1) + x)] = std::sin(0.2f * float(x)) * std::cos(0.15f * float(y));
    size_t before = 2 * kQuads * kQuads;
    for (const float tolerance : {0.01f, 0.05f, 0.3f}) {
        const Triangulation result =
            triangulate(heights, kQuads, tolerance, [](float a, float b) { return std::abs(a - b); });
        float worst = 0.0f;
        for (size_t i = 0; i < result.triangles.size(); i += 3) {
            const auto at = [&](size_t k) { return heights[result.triangles[i + k]]; };
            const auto place = [&](size_t k) {
                return glm::ivec2(result.triangles[i + k] % (kQuads + 1), result.triangles[i + k] / (kQuads + 1));
            };
            const glm::ivec2 middle = (place(0) + place(1)) / 2;
            if ((place(0) + place(1)) % 2 != glm::ivec2(0)) continue;
            worst = std::max(worst, std::abs(0.5f * (at(0) + at(1)) -
                                             heights[static_cast<size_t>(middle.y * (kQuads + 1) + middle.x)]));
        }
        std::printf("tolerance %.2f: %zu triangles, worst %.4f\n", double(tolerance), result.triangles.size() / 3,
                    double(worst));
        EXPECT_LE(worst, tolerance);
        EXPECT_LT(result.triangles.size() / 3, before);
        before = result.triangles.size() / 3;
    }
}

TEST(Quadrature, IsExactForPolynomials) {
    for (const int count : {4, 6, 12, 24}) {
        double sum = 0.0, even = 0.0;
        for (const glm::vec2& node : gauss_legendre(count)) {
            sum += double(node.y);
            even += double(node.y) * std::pow(double(node.x), 6);
        }
        EXPECT_NEAR(sum, 2.0, 1e-6) << count;
        EXPECT_NEAR(even, 2.0 / 7.0, 1e-6) << count;
    }
}

}  // namespace
}  // namespace tyndall::participating_media
