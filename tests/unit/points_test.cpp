// The module translucency: its kernels, its points, and that what it renders is the integral of the BSSRDF.

#include "points/point_cloud.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <numeric>

#include "double_loop.h"
#include "points/detail.h"
#include "radial_kernel.h"
#include "scene/primitives.h"

namespace tyndall::translucency {
namespace {

constexpr double kPi = std::numbers::pi;

const Optics kMarble{{2190, 2620, 3000}, {2.1f, 4.1f, 7.1f}, 1.5f};

// Kernels
// -----------------------------------------------------------------------------------------------------------------

TEST(RadialKernel, GaussiansAreTheModel) {
    for (const Optics& optics : {kPotato, kMarble})
        for (const Model model : {Model::normalised, Model::better, Model::standard, Model::photon_beams}) {
            const float radius = 2e-4f;
            const RadialKernel kernel(optics, model, Scaling::exact, radius);
            double worst = 0.0;
            for (float r = 0.3f * radius; r < 200.0f * radius; r *= 1.07f) {
                const glm::vec3 exact = kernel.exact(r);
                for (int c = 0; c < 3; ++c)  // where it is dark the error does not matter
                    if (exact[c] > 1e-6f * kernel.exact(0.0f)[c])
                        worst = std::max(worst, std::abs(double(kernel.at(r)[c]) / double(exact[c]) - 1.0));
            }
            std::printf("model %d: worst relative error of the fit %.4f\n", int(model), worst);
            EXPECT_LT(worst, model == Model::normalised ? 0.16 : 0.05) << "the normalised one is singular";
        }
}

TEST(RadialKernel, AllLeavesOnFlatGround) {
    for (const Optics& optics : {kPotato, kMarble})
        for (const Model model : {Model::normalised, Model::better, Model::photon_beams, Model::directional}) {
            const RadialKernel kernel(optics, model, Scaling::exact, 3e-4f);
            glm::dvec3 sum(0.0);
            const double step = 0.01;
            for (double x = std::log(1e-6); x < std::log(0.5); x += step) {
                const double r = std::exp(x + 0.5 * step);
                sum += 2.0 * kPi * r * r * step * glm::dvec3(kernel.at(float(r)));
            }
            std::printf("model %d: %.4f %.4f %.4f\n", int(model), sum.x, sum.y, sum.z);
            for (int c = 0; c < 3; ++c) EXPECT_NEAR(sum[c], 1.0, 0.02);
        }
}

// Points
// -----------------------------------------------------------------------------------------------------------------

Mesh sheet() {
    Mesh mesh = make_primitive(Primitive::box, 3);
    for (glm::vec3& p : mesh.positions) p *= glm::vec3(1.0f, 0.01f, 1.0f);
    mesh.bounds = bounds_of(mesh.positions);
    return mesh;
}

TEST(SurfacePoints, ShareTheSurface) {
    for (const Mesh& mesh : {make_primitive(Primitive::sphere, 64), sheet()}) {
        const std::vector<SurfacePoint> points = sample_surface(mesh, 10);
        ASSERT_EQ(points.size(), 1024u);
        double sum = 0.0, least = 1e9, most = 0.0;
        for (const SurfacePoint& point : points) {
            sum += double(point.area);
            least = std::min(least, double(point.area));
            most = std::max(most, double(point.area));
        }
        double area = 0.0;
        for (size_t t = 0; t < mesh.triangle_count(); ++t) {
            const uint32_t* i = &mesh.indices[3 * t];
            area += 0.5 * double(glm::length(glm::cross(mesh.positions[i[1]] - mesh.positions[i[0]],
                                                        mesh.positions[i[2]] - mesh.positions[i[0]])));
        }
        std::printf("pieces between %.2f and %.2f of the mean\n", least * 1024 / area, most * 1024 / area);
        EXPECT_NEAR(sum, area, 1e-4 * area);
        EXPECT_GT(least * 1024, 0.5 * area);
        EXPECT_LT(most * 1024, 1.6 * area);
    }
}

TEST(SurfacePoints, BothSidesOfASheetHaveTheirOwn) {
    int up = 0, down = 0;
    for (const SurfacePoint& point : sample_surface(sheet(), 9)) {
        up += point.normal.y > 0.9f ? 1 : 0;
        down += point.normal.y < -0.9f ? 1 : 0;
    }
    EXPECT_NEAR(up, down, 10);
    EXPECT_GT(up + down, 480);
}

TEST(SurfacePoints, NoneWithoutArea) {
    Mesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
    mesh.indices = {0, 1, 2};
    mesh.bounds = bounds_of(mesh.positions);
    EXPECT_TRUE(sample_surface(mesh, 8).empty());
    EXPECT_TRUE(make_point_cloud(mesh, 8, 0.5f, true).points.empty());
}

TEST(PointCloud, EveryClusterGathersFromEveryPointOnce) {
    const PointCloud cloud = make_point_cloud(make_primitive(Primitive::sphere, 48), 9, 0.5f, true);
    for (size_t c = 0; c + 1 < cloud.list_begins.size(); ++c) {
        std::vector<int> seen(cloud.points.size(), 0);
        for (size_t i = cloud.list_begins[c]; i < cloud.list_begins[c + 1]; ++i) {
            const uint32_t node = cloud.lists[i];
            int level = 0;
            while (level < cloud.levels && node >= cloud.first(level + 1)) ++level;
            const size_t first = size_t(node - cloud.first(level)) << size_t(level);
            for (size_t k = 0; k < size_t(1) << size_t(level); ++k) ++seen[first + k];
        }
        ASSERT_EQ(std::ranges::count(seen, 1), std::ptrdiff_t(seen.size())) << "cluster " << c;
    }
}

TEST(PointCloud, VerticesBlendPointsNearBy) {
    const Mesh mesh = make_primitive(Primitive::box, 3);
    const PointCloud cloud = make_point_cloud(mesh, 10, 0.5f, true);
    EXPECT_GT(cloud.vertices.size(), 1000u) << "large triangles are cut";
    for (const PointCloud::Vertex& vertex : cloud.vertices) {
        int sum = 0;
        for (size_t k = 0; k < PointCloud::kNeighbours; ++k) {
            sum += vertex.weights[k];
            if (vertex.weights[k] == 0) continue;
            ASSERT_LT(glm::distance(vertex.position, cloud.points[vertex.points[k]].position), 4.0f * cloud.spacing);
        }
        ASSERT_NEAR(sum, 255, 3);
    }
}

TEST(PointCloud, AConvexBodySeesNothingOfItselfAndACaveNothingElse) {
    Mesh mesh = make_primitive(Primitive::sphere, 64);
    EXPECT_TRUE(make_point_cloud(mesh, 10, 0.5f, true).sights.empty());
    EXPECT_TRUE(make_point_cloud(mesh, 10, 0.5f, false).sight_begins.empty());
    for (size_t i = 0; i < mesh.indices.size(); i += 3) std::swap(mesh.indices[i], mesh.indices[i + 1]);
    for (glm::vec3& normal : mesh.normals) normal = -normal;
    const PointCloud cave = make_point_cloud(mesh, 10, 0.5f, true);
    ASSERT_EQ(cave.sight_begins.size(), cave.points.size() / PointCloud::kSightGroup + 1);
    // each group sees all others alike, but for a few rays that meet the group itself
    const double rays = double(cave.points.size()) * PointCloud::kSightRays;
    EXPECT_GT(double(cave.sights.size()), 0.97 * rays);
    std::vector<double> met(cave.sight_begins.size() - 1);
    for (const uint32_t group : cave.sights) ++met[group];
    const double even = rays / double(met.size());
    for (const double count : met) EXPECT_NEAR(count, even, 0.45 * even);
}

TEST(PointDetail, FarThingsHaveFewerPoints) {
    FrameBlock frame{};
    frame.eye_near = {0.0f, 0.0f, 0.0f, 0.1f};
    frame.size_time = {640.0f, 360.0f, 0.0f, 0.0f};
    frame.tan_half_fov_exposure = {0.8f, 0.45f, 1.0f, 0.0f};
    Surface surface;
    surface.bounds = {{-1.0f, -1.0f, -11.0f}, {1.0f, 1.0f, -10.0f}};
    // a pixel covers 0.0025 m at 1 m, so 4 of them 0.1 m at the nearest place, 10 m away
    EXPECT_NEAR(points_worth(surface, 4.0f, frame, 4.0f), 400.0f, 1.0f);
    EXPECT_TRUE(std::isinf(points_worth(surface, 4.0f, frame, 0.0f)));
    EXPECT_EQ(levels_for(points_worth(surface, 4.0f, frame, 0.0f), 0, 15), 15);
    EXPECT_EQ(levels_for(4000.0f, 0, 15), 12);
    EXPECT_EQ(levels_for(10.0f, 0, 15), levels_for(1.0f, 0, 15)) << "some are always there";
    EXPECT_EQ(levels_for(4000.0f, 0, 10), 10);
    EXPECT_EQ(levels_for(std::nanf(""), 0, 15), levels_for(0.0f, 0, 15)) << "what has no size is worth the fewest";
    EXPECT_EQ(levels_for(4000.0f, 0, 6), 6);
}

TEST(PointDetail, AnEyeThatTremblesChangesNothing) {
    EXPECT_EQ(levels_for(4096.0f * 1.3f, 12, 15), 12);
    EXPECT_EQ(levels_for(4096.0f * 1.5f, 12, 15), 13);
    EXPECT_EQ(levels_for(4096.0f * 0.4f, 12, 15), 12);
    EXPECT_EQ(levels_for(4096.0f * 0.3f, 12, 15), 11);
    EXPECT_EQ(levels_for(4096.0f, 12, 11), 11) << "the scene now allows fewer";
}

// The whole: against a double loop over the mesh
// -----------------------------------------------------------------------------------------------------------------

class PointsTest : public DoubleLoopTest {
 protected:
    /// Compares blocks of pixels with the double loop.
    void expect_the_integral(const std::string& mesh_json, float scale) {
        expect_within(mesh_json, scale, 0.2f, 0.01, 0.03);
        expect_within(mesh_json, scale, PointsSettings{}.opening, 0.015, 0.11);
    }

    void expect_within(const std::string& mesh_json, float scale, float opening, double mean, double block) {
        std::ofstream(folder_ / "scene.json") << scene_text(
            mesh_json, scale,
            R"("points": {"pixels": 0, "interreflection": false, "opening": )" + std::to_string(opening) + "}",
            "points");
        Engine engine(true);
        engine.load_scene(folder_ / "scene.json", {});
        RenderScene scene = engine.extract();
        ASSERT_EQ(scene.surfaces.size(), 1u);
        engine.renderer().retain({"radiance", "scene_depth"});
        engine.renderer().render(scene, {kSize, kSize});
        EXPECT_EQ(engine.problems(), "");
        const Loop loop = double_loop(scene, picture(*engine.renderer().target("scene_depth")), {});
        const LoopErrors errors = errors_of(picture(*engine.renderer().target("radiance")), loop);
        EXPECT_GT(errors.pixels, 20u);
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(errors.mean[c], 1.0, mean);
        EXPECT_LT(errors.worst_block, block);
    }
};

TEST_F(PointsTest, ABallIsTheDoubleLoop) {
    expect_the_integral(R"("primitive": "sphere", "tessellation": 96)", 0.02f);
}

TEST_F(PointsTest, ACylinderOfLongTrianglesIsTheDoubleLoop) {
    expect_the_integral(R"("primitive": "cylinder", "tessellation": 64)", 0.014f);
}

TEST_F(PointsTest, AThinTorusIsTheDoubleLoop) {
    std::filesystem::copy_file(paths::root() / "assets/subjects/torus.ply", folder_ / "torus.ply");
    expect_the_integral(R"("file": "torus.ply")", 0.25f);
}

TEST_F(PointsTest, ABunnyIsTheDoubleLoop) {
    const std::filesystem::path bunny = paths::root() / "../shared/assets/models/mitsuba_bunny.ply";
    if (!std::filesystem::exists(bunny)) GTEST_SKIP() << bunny << " is not there";
    std::filesystem::copy_file(bunny, folder_ / "bunny.ply");
    expect_the_integral(R"("file": "bunny.ply")", 0.12f);
}

}  // namespace
}  // namespace tyndall::translucency
