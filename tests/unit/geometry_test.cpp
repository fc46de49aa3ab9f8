#include <gtest/gtest.h>

#include <cmath>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>

#include "core/error.h"
#include "geometry/curvature.h"
#include "geometry/mesh.h"
#include "geometry/polygons.h"

namespace tyndall {
namespace {

/// A box of half extent 1, quads, no attributes.
PolygonMesh box() {
    PolygonMesh mesh;
    for (int i = 0; i < 8; ++i) mesh.positions.emplace_back(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1);
    mesh.corners = {0, 2, 3, 1, 4, 5, 7, 6, 0, 1, 5, 4, 2, 6, 7, 3, 0, 4, 6, 2, 1, 3, 7, 5};
    mesh.face_sizes.assign(6, 4);
    return mesh;
}

/// A sphere of radius 1 in rings and sectors, with a seam in its UVs.
Mesh sphere(std::uint32_t rings, std::uint32_t sectors) {
    Mesh mesh;
    for (std::uint32_t r = 0; r <= rings; ++r)
        for (std::uint32_t s = 0; s <= sectors; ++s) {
            const float theta = std::numbers::pi_v<float> * static_cast<float>(r) / static_cast<float>(rings);
            const float phi =
                2 * std::numbers::pi_v<float> * static_cast<float>(s % sectors) / static_cast<float>(sectors);
            const float ring = r == 0 || r == rings ? 0.0f : std::sin(theta);
            mesh.positions.emplace_back(ring * std::sin(phi), std::cos(theta), ring * std::cos(phi));
            mesh.uv0.emplace_back(static_cast<float>(s) / static_cast<float>(sectors),
                                  static_cast<float>(r) / static_cast<float>(rings));
        }
    for (std::uint32_t r = 0; r < rings; ++r)
        for (std::uint32_t s = 0; s < sectors; ++s) {
            const std::uint32_t a = r * (sectors + 1) + s, b = a + sectors + 1;
            mesh.indices.insert(mesh.indices.end(), {a, b, b + 1, a, b + 1, a + 1});
        }
    return mesh;
}

double area(const Mesh& mesh) {
    double sum = 0;
    for (size_t i = 0; i < mesh.indices.size(); i += 3) {
        const auto p = [&](size_t k) { return mesh.positions[mesh.indices[i + k]]; };
        sum += 0.5 * static_cast<double>(glm::length(glm::cross(p(1) - p(0), p(2) - p(0))));
    }
    return sum;
}

void expect_frames(const Mesh& mesh) {
    ASSERT_EQ(mesh.normals.size(), mesh.positions.size());
    ASSERT_EQ(mesh.tangents.size(), mesh.positions.size());
    for (size_t i = 0; i < mesh.positions.size(); ++i) {
        const glm::vec3 tangent(mesh.tangents[i]);
        ASSERT_NEAR(glm::length(mesh.normals[i]), 1, 1e-5f);
        ASSERT_NEAR(glm::length(tangent), 1, 1e-5f);
        ASSERT_NEAR(glm::dot(tangent, mesh.normals[i]), 0, 1e-5f);
        ASSERT_EQ(std::abs(mesh.tangents[i].w), 1);
    }
}

TEST(Bounds, HoldWhatWasAdded) {
    Bounds bounds;
    EXPECT_TRUE(bounds.empty());
    EXPECT_EQ(bounds.radius(), 0);
    EXPECT_TRUE(bounds.transformed(glm::mat4(2.0f)).empty());
    bounds.add({1, 2, 3});
    EXPECT_FALSE(bounds.empty());
    bounds.add({-1, 4, 3});
    EXPECT_EQ(bounds.centre(), glm::vec3(0, 3, 3));
    EXPECT_EQ(bounds.size(), glm::vec3(2, 2, 0));
    EXPECT_FLOAT_EQ(bounds.radius(), std::sqrt(2.0f));
    Bounds other;
    other.add({5, 5, 5});
    other.merge(Bounds());
    bounds.merge(other);
    EXPECT_TRUE(bounds.contains({5, 2, 4}));
    EXPECT_FALSE(bounds.contains({5, 2, 6}));
}

TEST(Bounds, TransformedHoldsEveryTransformedCorner) {
    const Bounds bounds{{-1, 2, 0}, {3, 5, 0.5f}};
    const glm::mat4 transform =
        glm::rotate(glm::translate(glm::mat4(1.0f), {1, -2, 3}), 0.7f, glm::normalize(glm::vec3(1, 2, -1)));
    const Bounds moved = bounds.transformed(transform);
    Bounds exact;
    for (int i = 0; i < 8; ++i)
        exact.add(
            glm::vec3(transform * glm::vec4(i & 1 ? bounds.low.x : bounds.high.x, i & 2 ? bounds.low.y : bounds.high.y,
                                            i & 4 ? bounds.low.z : bounds.high.z, 1)));
    for (int c = 0; c < 3; ++c) {
        EXPECT_NEAR(moved.low[c], exact.low[c], 1e-5f);
        EXPECT_NEAR(moved.high[c], exact.high[c], 1e-5f);
    }
}

TEST(Triangulate, BoxKeepsItsAreaAndDirection) {
    const Mesh mesh = triangulate(box());
    EXPECT_EQ(mesh.triangle_count(), 12u);
    EXPECT_EQ(mesh.positions.size(), 8u);
    EXPECT_NEAR(area(mesh), 24, 1e-5);
    EXPECT_EQ(mesh.bounds.high, glm::vec3(1));
    for (size_t i = 0; i < mesh.indices.size(); i += 3) {
        const auto p = [&](size_t k) { return mesh.positions[mesh.indices[i + k]]; };
        EXPECT_GT(glm::dot(glm::cross(p(1) - p(0), p(2) - p(0)), p(0) + p(1) + p(2)), 0) << "faces look outwards";
    }
}

TEST(Triangulate, ConcavePolygonsKeepTheirShape) {
    PolygonMesh comb;  // a comb with three teeth, area 3 + 3 x 2
    for (const auto& [x, y] : std::vector<std::pair<float, float>>{{0, 0},
                                                                   {6, 0},
                                                                   {6, 2.5f},
                                                                   {5, 2.5f},
                                                                   {5, .5f},
                                                                   {4, .5f},
                                                                   {4, 2.5f},
                                                                   {3, 2.5f},
                                                                   {3, .5f},
                                                                   {2, .5f},
                                                                   {2, 2.5f},
                                                                   {0, 2.5f}})
        comb.positions.emplace_back(x, y, 0);
    for (std::uint32_t i = 0; i < comb.positions.size(); ++i) comb.corners.push_back(i);
    comb.face_sizes = {12};
    const Mesh mesh = triangulate(comb);
    EXPECT_EQ(mesh.triangle_count(), 10u);
    EXPECT_NEAR(area(mesh), 3 + 2 * 2 + 1 * 2 + 1 * 2, 1e-5);

    PolygonMesh dart;  // a quad with a corner that points inwards
    dart.positions = {{0, 0, 0}, {2, 1, 0}, {0, 2, 0}, {0.5f, 1, 0}};
    dart.corners = {0, 1, 2, 3};
    dart.face_sizes = {4};
    EXPECT_NEAR(area(triangulate(dart)), 1.5, 1e-6);
}

TEST(Triangulate, SeamsSplitVertices) {
    PolygonMesh mesh = box();
    mesh.uvs = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    for (int face = 0; face < 6; ++face) mesh.uv_corners.insert(mesh.uv_corners.end(), {0, 1, 2, 3});
    const Mesh split = triangulate(mesh);
    EXPECT_GT(split.positions.size(), 8u);
    EXPECT_LE(split.positions.size(), 24u);
    EXPECT_EQ(split.uv0.size(), split.positions.size());
    EXPECT_NO_THROW(validate(split, "box"));
}

TEST(Triangulate, RefusesWhatIsNoMesh) {
    const auto broken = [](auto&& change) {
        PolygonMesh mesh = box();
        change(mesh);
        return mesh;
    };
    EXPECT_THROW((void)triangulate({}), Error);
    EXPECT_THROW((void)triangulate(broken([](auto& m) { m.corners[3] = 8; })), Error);
    EXPECT_THROW((void)triangulate(broken([](auto& m) { m.face_sizes[0] = 5; })), Error);
    EXPECT_THROW((void)triangulate(broken([](auto& m) { m.face_sizes = {22, 2}; })), Error);
    EXPECT_THROW((void)triangulate(broken([](auto& m) { m.positions[0].x = NAN; })), Error);
    EXPECT_THROW((void)triangulate(broken([](auto& m) { m.uv_corners = {0}; })), Error);
}

TEST(Normals, SmoothSphereIsASphere) {
    Mesh mesh = sphere(24, 48);
    compute_normals(mesh);
    for (size_t i = 0; i < mesh.positions.size(); ++i)
        ASSERT_GT(glm::dot(mesh.normals[i], glm::normalize(mesh.positions[i])), 0.999f) << "the seam must not show";
}

TEST(Normals, CreasesKeepBoxesHard) {
    Mesh hard = triangulate(box());
    compute_normals(hard, kDefaultCrease);
    EXPECT_EQ(hard.positions.size(), 24u);
    for (const glm::vec3& n : hard.normals)
        EXPECT_NEAR(std::max({std::abs(n.x), std::abs(n.y), std::abs(n.z)}), 1, 1e-6f);
    Mesh smooth = triangulate(box());
    compute_normals(smooth);
    EXPECT_EQ(smooth.positions.size(), 8u);
    for (size_t i = 0; i < 8; ++i)  // weighted by angle, the way that a quad is cut does not matter
        EXPECT_NEAR(glm::distance(smooth.normals[i], smooth.positions[i] / std::sqrt(3.0f)), 0, 1e-5f);
    Mesh round = sphere(24, 48);
    const size_t before = round.positions.size();
    compute_normals(round, kDefaultCrease);
    EXPECT_LE(round.positions.size(), before) << "a smooth surface is not split";
}

TEST(Normals, DegenerateTrianglesAreHarmless) {
    Mesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
    mesh.indices = {0, 1, 2, 0, 0, 1};
    compute_normals(mesh, kDefaultCrease);
    compute_tangents(mesh);
    expect_frames(mesh);
}

TEST(Curvatures, AreThoseOfSpheresAndSheets) {
    for (const float radius : {0.01f, 1.0f, 30.0f}) {
        Mesh mesh = sphere(24, 48);
        for (glm::vec3& p : mesh.positions) p *= radius;
        compute_normals(mesh);
        for (const float smoothing : {0.0f, 0.2f * radius}) {
            compute_curvatures(mesh, smoothing);
            for (const float curvature : mesh.curvatures)
                ASSERT_NEAR(curvature * radius, 1.0f, 0.03f)
                    << "radius " << radius << ", also at the seam and the poles";
        }
    }
    Mesh inside_out = sphere(24, 48);
    compute_normals(inside_out);
    for (glm::vec3& n : inside_out.normals) n = -n;
    compute_curvatures(inside_out, 0.1f);
    EXPECT_NEAR(inside_out.curvatures.at(400), -1.0f, 0.03f) << "hollow is negative";
    Mesh bare = sphere(4, 4);
    EXPECT_THROW(compute_curvatures(bare, 0.1f), Error) << "it has no normals";
}

TEST(Tangents, FollowU) {
    Mesh quad;  // in the xy plane, the picture upright
    quad.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    quad.uv0 = {{0, 1}, {1, 1}, {1, 0}, {0, 0}};
    quad.indices = {0, 1, 2, 0, 2, 3};
    compute_normals(quad);
    compute_tangents(quad);
    for (const glm::vec4& t : quad.tangents) EXPECT_EQ(t, glm::vec4(1, 0, 0, 1));  // bitangent +Y: up in the picture
    for (glm::vec2& uv : quad.uv0) uv.x = 1 - uv.x;                                // mirrored
    compute_tangents(quad);
    for (const glm::vec4& t : quad.tangents) EXPECT_EQ(t, glm::vec4(-1, 0, 0, -1));
}

TEST(Tangents, SphereHasFramesEverywhere) {
    Mesh mesh = sphere(16, 32);
    compute_normals(mesh);
    compute_tangents(mesh);
    expect_frames(mesh);
    for (size_t i = 0; i < mesh.positions.size(); ++i) {
        if (std::abs(mesh.positions[i].y) > 0.9f) continue;
        const glm::vec3 east = glm::normalize(glm::cross(glm::vec3(0, 1, 0), mesh.positions[i]));
        ASSERT_GT(glm::dot(glm::vec3(mesh.tangents[i]), east), 0.99f);
        ASSERT_EQ(mesh.tangents[i].w, 1);
    }
}

TEST(Tangents, MirroredHalvesAreSplit) {
    Mesh mesh;  // u grows away from the middle edge on both sides
    mesh.positions = {{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {1, 1, 0}, {-1, 0, 0}, {-1, 1, 0}};
    mesh.uv0 = {{0, 1}, {0, 0}, {1, 1}, {1, 0}, {1, 1}, {1, 0}};
    mesh.indices = {0, 2, 3, 0, 3, 1, 4, 0, 1, 4, 1, 5};
    compute_normals(mesh);
    compute_tangents(mesh);
    expect_frames(mesh);
    EXPECT_EQ(mesh.positions.size(), 8u);
    for (size_t c = 0; c < mesh.indices.size(); ++c) {
        const glm::vec4 tangent = mesh.tangents[mesh.indices[c]];
        EXPECT_EQ(tangent, c < 6 ? glm::vec4(1, 0, 0, 1) : glm::vec4(-1, 0, 0, -1));
    }
}

TEST(Tangents, WithoutUvsAnyFrameWillDo) {
    Mesh mesh = sphere(8, 16);
    mesh.uv0.clear();
    EXPECT_THROW(compute_tangents(mesh), Error);
    compute_normals(mesh);
    compute_tangents(mesh);
    expect_frames(mesh);
    mesh.uv0.assign(mesh.positions.size(), glm::vec2(0.5f));
    compute_tangents(mesh);
    expect_frames(mesh);
}

TEST(Validate, NamesTheTrouble) {
    Mesh mesh = sphere(4, 8);
    EXPECT_NO_THROW(validate(mesh, "ball.glb"));
    mesh.indices[4] = 4000;
    try {
        validate(mesh, "ball.glb");
        FAIL();
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find("ball.glb: a triangle names vertex 4000"), std::string::npos)
            << error.what();
    }
    mesh = sphere(4, 8);
    mesh.uv0.pop_back();
    EXPECT_THROW(validate(mesh, "ball.glb"), Error);
    mesh = sphere(4, 8);
    mesh.positions[1].y = std::numeric_limits<float>::infinity();
    EXPECT_THROW(validate(mesh, "ball.glb"), Error);
}

}  // namespace
}  // namespace tyndall
