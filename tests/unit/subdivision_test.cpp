#include "geometry/subdivision.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <glm/geometric.hpp>

#include "core/error.h"

namespace tyndall {
namespace {

PolygonMesh box() {
    PolygonMesh mesh;
    for (int i = 0; i < 8; ++i) mesh.positions.emplace_back(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1);
    mesh.corners = {0, 2, 3, 1, 4, 5, 7, 6, 0, 1, 5, 4, 2, 6, 7, 3, 0, 4, 6, 2, 1, 3, 7, 5};
    mesh.face_sizes.assign(6, 4);
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

TEST(Subdivision, BoxBecomesARoundBody) {
    // The limit of a corner of valence 3 is (9 v + 4 sum of edge neighbours + sum of those across the faces) / 24: in
    // each coordinate (9 + 4 - 1) / 24.
    const Mesh zero = subdivide(box(), 0);
    ASSERT_EQ(zero.positions.size(), 8u);
    for (const glm::vec3& p : zero.positions) EXPECT_NEAR(std::abs(p.x), 0.5f, 1e-5f);
    const Mesh mesh = subdivide(box(), 3);
    EXPECT_EQ(mesh.triangle_count(), 6u * 64 * 2);
    EXPECT_EQ(mesh.positions.size(), 6u * 64 + 2) << "closed: Euler's formula";
    for (size_t i = 0; i < mesh.positions.size(); ++i) {
        EXPECT_LE(std::abs(mesh.positions[i].x), 1);
        EXPECT_NEAR(glm::length(mesh.normals[i]), 1, 1e-5f);
        EXPECT_GT(glm::dot(mesh.normals[i], glm::normalize(mesh.positions[i])), 0.9f) << "normals look outwards";
    }
    EXPECT_FALSE(mesh.bounds.empty());
}

TEST(Subdivision, LevelsConverge) {
    // Limit points of coarse levels lie on the surface that finer levels approach from inside.
    double last = area(subdivide(box(), 1)), step = 1e9;
    for (int level = 2; level <= 5; ++level) {
        const double now = area(subdivide(box(), level));
        EXPECT_GT(now, last);
        EXPECT_LT(now - last, 0.5 * step);
        step = now - last;
        last = now;
    }
}

TEST(Subdivision, NormalsAreThoseOfTheSurface) {
    const Mesh mesh = subdivide(box(), 5);
    Mesh numeric = mesh;
    compute_normals(numeric);
    ASSERT_EQ(numeric.positions.size(), mesh.positions.size());
    std::vector<glm::vec3> of_place(mesh.positions.size());
    for (size_t c = 0; c < mesh.indices.size(); ++c) of_place[mesh.indices[c]] = numeric.normals[numeric.indices[c]];
    for (size_t i = 0; i < mesh.positions.size(); ++i) EXPECT_GT(glm::dot(of_place[i], mesh.normals[i]), 0.999f);
}

TEST(Subdivision, CreasesStaySharp) {
    const std::vector<Crease> top{{2, 3}, {3, 7}, {7, 6}, {6, 2}};
    const Mesh creased = subdivide(box(), 3, top);
    const Mesh round = subdivide(box(), 3);
    EXPECT_NEAR(creased.bounds.high.y, 1, 1e-5f) << "the top stays flat";
    EXPECT_LT(round.bounds.high.y, 0.9f);
    EXPECT_THROW((void)subdivide(box(), 1, std::vector<Crease>{{0, 99}}), Error);
}

TEST(Subdivision, BoundariesAndCornersStay) {
    PolygonMesh sheet;
    for (int y = 0; y < 3; ++y)
        for (int x = 0; x < 3; ++x) {
            sheet.positions.emplace_back(x, y, 0);
            sheet.uvs.emplace_back(static_cast<float>(x) / 2, static_cast<float>(y) / 2);
        }
    for (std::uint32_t y = 0; y < 2; ++y)
        for (std::uint32_t x = 0; x < 2; ++x) {
            const std::uint32_t a = y * 3 + x;
            sheet.corners.insert(sheet.corners.end(), {a, a + 1, a + 4, a + 3});
            sheet.face_sizes.push_back(4);
        }
    sheet.uv_corners = sheet.corners;
    const Mesh mesh = subdivide(sheet, 3);
    EXPECT_NEAR(area(mesh), 4, 1e-4);
    EXPECT_EQ(mesh.bounds.low, glm::vec3(0));
    EXPECT_EQ(mesh.bounds.high, glm::vec3(2, 2, 0));
    ASSERT_EQ(mesh.uv0.size(), mesh.positions.size());
    for (size_t i = 0; i < mesh.positions.size(); ++i) {  // the picture lies straight on the sheet
        EXPECT_NEAR(mesh.uv0[i].x, mesh.positions[i].x / 2, 0.02f);
        EXPECT_NEAR(mesh.uv0[i].y, mesh.positions[i].y / 2, 0.02f);
        EXPECT_NEAR(mesh.normals[i].z, 1, 1e-5f);
    }
}

TEST(Subdivision, UvSeamsStay) {
    PolygonMesh mesh = box();
    mesh.uvs = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};  // every face shows the whole picture
    for (int face = 0; face < 6; ++face) mesh.uv_corners.insert(mesh.uv_corners.end(), {0, 1, 2, 3});
    const Mesh fine = subdivide(mesh, 2);
    double uv_area = 0;
    for (size_t i = 0; i < fine.indices.size(); i += 3) {
        const auto uv = [&](size_t k) { return fine.uv0[fine.indices[i + k]]; };
        const glm::vec2 a = uv(1) - uv(0), b = uv(2) - uv(0);
        uv_area += 0.5 * std::abs(static_cast<double>(a.x * b.y - a.y * b.x));
    }
    EXPECT_NEAR(uv_area, 6, 1e-3);
    EXPECT_GT(fine.positions.size(), 6u * 16 + 2) << "vertices on seams are split";
}

TEST(Subdivision, PolygonsOfAnyKind) {
    PolygonMesh pyramid;  // triangles and a pentagon, and a vertex that nothing uses
    for (int i = 0; i < 5; ++i) {
        const float angle = 6.2831853f * static_cast<float>(i) / 5;
        pyramid.positions.emplace_back(std::cos(angle), 0, -std::sin(angle));
    }
    pyramid.positions.emplace_back(0, 1, 0);
    pyramid.positions.emplace_back(9, 9, 9);
    pyramid.corners = {4, 3, 2, 1, 0};
    pyramid.face_sizes = {5};
    for (std::uint32_t i = 0; i < 5; ++i) {
        pyramid.corners.insert(pyramid.corners.end(), {i, (i + 1) % 5, 5});
        pyramid.face_sizes.push_back(3);
    }
    const Mesh mesh = subdivide(pyramid, 2);
    EXPECT_EQ(mesh.triangle_count(), 20u * 4 * 2);
    EXPECT_LT(mesh.bounds.high.x, 1);
}

TEST(Subdivision, RefusesWhatIsNoSurface) {
    EXPECT_THROW((void)subdivide(box(), -1), Error);
    EXPECT_THROW((void)subdivide(box(), 9), Error);
    PolygonMesh broken = box();
    broken.corners[5] = 77;
    EXPECT_THROW((void)subdivide(broken, 1), Error);
    EXPECT_THROW((void)subdivide(PolygonMesh{}, 1), Error);
    PolygonMesh large = box();
    for (int i = 0; i < 12; ++i) {
        large.corners.insert(large.corners.end(), large.corners.begin(), large.corners.end());
        large.face_sizes.insert(large.face_sizes.end(), large.face_sizes.begin(), large.face_sizes.end());
    }
    EXPECT_THROW((void)subdivide(large, 8), Error);
    // Three faces on an edge, a face that names a vertex twice: no surface, but no crash either.
    PolygonMesh odd = box();
    odd.positions.emplace_back(3, 3, 3);
    odd.corners.insert(odd.corners.end(), {0, 1, 8, 2, 2, 3});
    odd.face_sizes.insert(odd.face_sizes.end(), {3, 3});
    try {
        EXPECT_NO_THROW(validate(subdivide(odd, 2), "odd"));
    } catch (const Error&) {
    }
}

TEST(Subdivision, Spot) {
    const std::filesystem::path file = "../shared/assets/models/spot/spot_control_mesh.obj";
    if (!std::filesystem::exists(file)) GTEST_SKIP() << "no " << file << ": the cow is not subdivided";
    const PolygonMesh control = load_polygons(file);
    const Bounds hull = bounds_of(control.positions);
    Bounds picture;
    for (const glm::vec2& uv : control.uvs) picture.add({uv, 0});
    double last = area(subdivide(control, 1)), step = 1e9;
    for (int level = 2; level <= 4; ++level) {
        Mesh mesh = subdivide(control, level);
        EXPECT_NO_THROW(validate(mesh, "spot"));
        for (const glm::vec3& p : mesh.positions) ASSERT_TRUE(hull.contains(p));
        for (const glm::vec3& n : mesh.normals) ASSERT_NEAR(glm::length(n), 1, 1e-4f);
        for (const glm::vec2& uv : mesh.uv0) {
            EXPECT_GE(uv.x, picture.low.x - 1e-5f);
            EXPECT_GE(uv.y, picture.low.y - 1e-5f);
            EXPECT_LE(uv.x, picture.high.x + 1e-5f);
            EXPECT_LE(uv.y, picture.high.y + 1e-5f);
        }
        compute_tangents(mesh);
        ASSERT_EQ(mesh.tangents.size(), mesh.positions.size());
        const double now = area(mesh);
        EXPECT_LT(std::abs(now - last), 0.5 * step);
        step = std::abs(now - last);
        last = now;
    }
}

}  // namespace
}  // namespace tyndall
