// What the technique htsm makes of a mesh, a density and an interior.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "htsm/htsm_pass.h"
#include "htsm/object_grid.h"
#include "htsm/solid.h"
#include "phase_table.h"
#include "render/pixel_rectangle.h"
#include "scene/primitives.h"

namespace tyndall::translucency {
namespace {

double volume_of(const ObjectGrid& grid) {
    double sum = 0.0;
    for (const float share : grid.inside) sum += double(share);
    const glm::dvec3 voxel(grid.voxel());
    return sum * voxel.x * voxel.y * voxel.z;
}

float inside_at(const ObjectGrid& grid, glm::vec3 p) {
    const glm::ivec3 at((p - grid.box.low) / grid.voxel());
    return grid.inside[(size_t(at.z) * size_t(grid.size.y) + size_t(at.y)) * size_t(grid.size.x) + size_t(at.x)];
}

void append(Mesh& to, const Mesh& from, glm::vec3 offset) {
    const auto first = uint32_t(to.positions.size());
    for (const glm::vec3& p : from.positions) to.positions.push_back(p + offset);
    for (const uint32_t i : from.indices) to.indices.push_back(first + i);
    to.bounds = bounds_of(to.positions);
}

TEST(ObjectGrid, HoldsTheVolumeOfABall) {
    for (const int resolution : {16, 64}) {
        const ObjectGrid grid = make_object_grid(make_primitive(Primitive::sphere, 256), resolution);
        const double error = volume_of(grid) / (std::numbers::pi / 6.0) - 1.0;
        std::printf("%d voxels: volume off by %.5f\n", resolution, error);
        EXPECT_LT(std::abs(error), 0.002);
        EXPECT_EQ(grid.open_share, 0.0f);
        EXPECT_EQ(grid.size, glm::ivec3(resolution + 2));
        EXPECT_EQ(inside_at(grid, glm::vec3(0.0f)), 1.0f);
        EXPECT_EQ(inside_at(grid, glm::vec3(0.45f)), 0.0f);
        EXPECT_EQ(grid.inside.front(), 0.0f);
    }
}

TEST(ObjectGrid, CutsABoxExactly) {
    const ObjectGrid grid = make_object_grid(make_primitive(Primitive::box, 8), 32);
    EXPECT_NEAR(volume_of(grid), 1.0, 1e-4);
    EXPECT_NEAR(inside_at(grid, glm::vec3(0.49f, 0.49f, 0.49f)), 1.0f, 1e-4f);
}

TEST(ObjectGrid, CountsOverlapsOnce) {
    Mesh mesh;
    append(mesh, make_primitive(Primitive::box, 8), glm::vec3(0.0f));
    append(mesh, make_primitive(Primitive::box, 8), glm::vec3(0.5f, 0.0f, 0.0f));
    EXPECT_NEAR(volume_of(make_object_grid(mesh, 30)), 1.5, 1e-3);
}

TEST(ObjectGrid, LeavesOutAHollow) {
    Mesh mesh, inner = make_primitive(Primitive::box, 8);
    append(mesh, inner, glm::vec3(0.0f));
    for (glm::vec3& p : inner.positions) p *= 0.5f;
    for (size_t i = 0; i < inner.indices.size(); i += 3) std::swap(inner.indices[i], inner.indices[i + 1]);
    append(mesh, inner, glm::vec3(0.0f));
    const ObjectGrid grid = make_object_grid(mesh, 32);
    EXPECT_NEAR(volume_of(grid), 1.0 - 0.125, 1e-3);
    EXPECT_EQ(inside_at(grid, glm::vec3(0.0f)), 0.0f);
}

TEST(ObjectGrid, FillsAnOpenMeshAndSaysSo) {
    Mesh mesh = make_primitive(Primitive::sphere, 64);
    std::vector<uint32_t> kept;
    for (size_t i = 0; i < mesh.indices.size(); i += 3)
        if (mesh.positions[mesh.indices[i]].x < 0.45f)
            kept.insert(kept.end(), mesh.indices.begin() + long(i), mesh.indices.begin() + long(i) + 3);
    ASSERT_LT(kept.size(), mesh.indices.size());
    mesh.indices = kept;
    const ObjectGrid grid = make_object_grid(mesh, 32);
    std::printf("a ball without its cap: %.3f of the lines are open\n", double(grid.open_share));
    EXPECT_GT(grid.open_share, 0.02f);
    EXPECT_LT(grid.open_share, 0.5f);
    // what lies beside the hole is there
    EXPECT_EQ(inside_at(grid, glm::vec3(0.0f, 0.3f, 0.0f)), 1.0f);
    EXPECT_EQ(inside_at(grid, glm::vec3(0.45f, 0.4f, 0.0f)), 0.0f);
}

TEST(ObjectGrid, IsEmptyWithoutAnInside) {
    EXPECT_EQ(make_object_grid(make_primitive(Primitive::plane, 8), 64).size, glm::ivec3(0));
    EXPECT_EQ(make_object_grid(Mesh{}, 64).size, glm::ivec3(0));
}

TEST(ObjectGrid, TakesItsDensityAtVoxelsCentres) {
    ObjectGrid grid = make_object_grid(make_primitive(Primitive::box, 8), 16);
    const GradientDensity ramp{.from = {0, -0.5f, 0}, .to = {0, 0.5f, 0}, .start = 1.0f, .end = 0.0f};
    fill_density(grid, DensityEvaluator(ramp, glm::mat4(1.0f), 0.0));
    for (int y = 1; y <= 16; ++y) {
        const size_t i = (size_t(5) * size_t(grid.size.y) + size_t(y)) * size_t(grid.size.x) + 7;
        EXPECT_NEAR(grid.density[i], 1.0f - (float(y) - 0.5f) / 16.0f, 1e-4f);
    }
    fill_density(grid, DensityEvaluator(ConstantDensity{}, glm::mat4(1.0f), 0.0));
    EXPECT_EQ(grid.density[77], 1.0f);
}

TEST(Densities, AreToldApart) {
    const BlobDensity blobs{{{.centre = glm::vec3(0.1f), .radius = 0.2f, .weight = 1.0f}}};
    BlobDensity other = blobs;
    EXPECT_TRUE(same_density(blobs, other));
    other.blobs[0].weight = 0.5f;
    EXPECT_FALSE(same_density(blobs, other));
    EXPECT_FALSE(same_density(blobs, ConstantDensity{}));
    EXPECT_FALSE(same_density(GridDensity{.scale = 1.0f}, GridDensity{.scale = 2.0f}));
    const ProductDensity layered{.base = std::make_shared<const DensityField>(blobs), .layer = HeightDensity{}};
    EXPECT_TRUE(moves_with_world(layered));
    EXPECT_FALSE(moves_with_world(blobs));
    EXPECT_TRUE(moves_with_world(NoiseDensity{}));
}

TEST(Transport, IsWhatDiffusionLeaves) {
    const ScatteringInterior interior{.sigma_s_per_m = glm::vec3(1000.0f), .sigma_a_per_m = {1.0f, 10.0f, 100.0f}};
    const glm::vec4 found = transport_of(interior, 10.0f);
    const glm::vec3 decay(std::sqrt(3.0f * 1001.0f), std::sqrt(30.0f * 1010.0f), std::sqrt(300.0f * 1100.0f));
    EXPECT_NEAR(found.w, 3.0f / (decay.x + decay.y + decay.z), 1e-6f);
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(found[i], std::exp(-decay[i] * found.w), 1e-5f);
    EXPECT_EQ(transport_of(interior, 10.0f, 0.25f).w, 0.25f);
    // no absorption: as far as the object goes, and white
    const glm::vec4 clear = transport_of({.sigma_s_per_m = glm::vec3(1000.0f)}, 0.04f);
    EXPECT_EQ(clear, glm::vec4(1.0f, 1.0f, 1.0f, 0.04f));
}

TEST(PhaseRow, IntegratesToOne) {
    for (const float g : {0.0f, 0.4f, 0.9f, -0.6f}) {
        const PhaseFunction phase{PhaseKind::henyey_greenstein, glm::vec4(g, 0, 0, 0), nullptr};
        const std::vector<glm::vec4> row = phase_row(phase, 1024);
        double sum = 0.0;
        for (size_t i = 0; i < row.size(); ++i) {
            const double angle = std::numbers::pi * double(i) / 1023.0;
            sum += 2.0 * std::numbers::pi * std::sin(angle) * double(row[i].x) * std::numbers::pi / 1023.0;
        }
        std::printf("g %.1f: %.5f\n", double(g), sum);
        EXPECT_NEAR(sum, 1.0, 2e-3);
    }
    const auto table = std::make_shared<PhaseTable>(PhaseTable{.values = {glm::vec3(3.0f), glm::vec3(1.0f)}});
    EXPECT_NEAR(phase_row({PhaseKind::tabulated, glm::vec4(0.0f), table}, 5)[1].y, 2.5f, 1e-6f);
}

TEST(Pixels, HoldABox) {
    // looks along -z from the origin, 90 degrees
    glm::mat4 clip(0.0f);
    clip[0][0] = clip[1][1] = 1.0f;
    clip[2][3] = -1.0f;
    clip[3][2] = 0.1f;
    const PixelRectangle found = pixels_of({{-1.0f, 0.0f, -4.0f}, {1.0f, 1.0f, -2.0f}}, clip, {100, 40});
    EXPECT_EQ(found.low, glm::ivec2(25, 20));
    EXPECT_EQ(found.size, glm::ivec2(50, 10));
    const PixelRectangle around = pixels_of({glm::vec3(-1.0f), glm::vec3(1.0f)}, clip, {100, 40});
    EXPECT_EQ(around.size, glm::ivec2(100, 40));
    EXPECT_TRUE(pixels_of({{5.0f, 0.0f, -3.0f}, {6.0f, 1.0f, -2.0f}}, clip, {100, 40}).empty());
}

TEST(Pattern, IsOneOfFour) {
    EXPECT_EQ(whole_pattern(1), 1);
    EXPECT_EQ(whole_pattern(2), 5);
    EXPECT_EQ(whole_pattern(9), 9);
    EXPECT_EQ(whole_pattern(10), 13);
}

}  // namespace
}  // namespace tyndall::translucency
