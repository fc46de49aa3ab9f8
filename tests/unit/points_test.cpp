// The module translucency: its kernels, its points, and that what it renders is the integral of the BSSRDF.

#include "points/point_cloud.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <numeric>

#include "app/engine.h"
#include "core/parallel.h"
#include "core/paths.h"
#include "points/detail.h"
#include "radial_kernel.h"
#include "renderer_fixture.h"
#include "scene/primitives.h"

namespace tyndall::translucency {
namespace {

constexpr double kPi = std::numbers::pi;

const Optics kPotato{{680, 700, 550}, {2.4f, 9.0f, 120.0f}, 1.3f};
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
    EXPECT_TRUE(make_point_cloud(mesh, 8, 0.5f).points.empty());
}

TEST(PointCloud, EveryClusterGathersFromEveryPointOnce) {
    const PointCloud cloud = make_point_cloud(make_primitive(Primitive::sphere, 48), 9, 0.5f);
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
    const PointCloud cloud = make_point_cloud(mesh, 10, 0.5f);
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

/// Integral over a triangle of the exitance at `at`, lit along `to_light` by 1 lux: cut until pieces are small for
/// their distance.
glm::dvec3 over_triangle(const std::array<glm::vec3, 3>& p, const std::array<glm::vec3, 3>& n, const glm::vec3& at,
                         const glm::vec3& to_light, double path, int depth = 0) {
    const glm::vec3 middle = (p[0] + p[1] + p[2]) / 3.0f;
    const double edge =
        double(std::max({glm::distance(p[0], p[1]), glm::distance(p[1], p[2]), glm::distance(p[2], p[0])}));
    const double r = double(glm::distance(middle, at));
    if (edge > 0.3 * std::max(r, path) && depth < 6) {
        const std::array<glm::vec3, 3> q{0.5f * (p[0] + p[1]), 0.5f * (p[1] + p[2]), 0.5f * (p[2] + p[0])};
        const std::array<glm::vec3, 3> m{0.5f * (n[0] + n[1]), 0.5f * (n[1] + n[2]), 0.5f * (n[2] + n[0])};
        return over_triangle({p[0], q[0], q[2]}, {n[0], m[0], m[2]}, at, to_light, path, depth + 1) +
               over_triangle({q[0], p[1], q[1]}, {m[0], n[1], m[1]}, at, to_light, path, depth + 1) +
               over_triangle({q[2], q[1], p[2]}, {m[2], m[1], n[2]}, at, to_light, path, depth + 1) +
               over_triangle({q[0], q[1], q[2]}, {m[0], m[1], m[2]}, at, to_light, path, depth + 1);
    }
    const float cosine = glm::dot(glm::normalize(n[0] + n[1] + n[2]), to_light);
    if (cosine <= 0.0f) return glm::dvec3(0.0);
    const double area = 0.5 * double(glm::length(glm::cross(p[1] - p[0], p[2] - p[0])));
    Optics matched = kPotato;
    matched.eta = 1.0f;
    return area * double(cosine) * glm::dvec3(exitance(Model::better, matched, float(r)));
}

class PointsTest : public RendererTest {
 protected:
    /// Renders a mesh of potato of about 20 mm without refraction, as the model was published, and compares blocks of
    /// pixels with the double loop. `file` in a folder of its own, or a primitive's name.
    void expect_the_integral(const std::string& mesh_json, float scale) {
        expect_within(mesh_json, scale, 0.2f, 0.01, 0.03);
        expect_within(mesh_json, scale, PointsSettings{}.opening, 0.015, 0.11);
    }

    void expect_within(const std::string& mesh_json, float scale, float opening, double mean, double block) {
        std::ofstream(folder_ / "scene.json") << scene_text(mesh_json, scale, opening);
        Engine engine(true);
        engine.load_scene(folder_ / "scene.json", {});
        RenderScene scene = engine.extract();
        ASSERT_EQ(scene.surfaces.size(), 1u);
        engine.renderer().retain({"radiance", "scene_depth"});
        engine.renderer().render(scene, {kSize, kSize});
        EXPECT_EQ(engine.problems(), "");
        compare(scene, picture(*engine.renderer().target("radiance")),
                picture(*engine.renderer().target("scene_depth")), mean, block);
    }

    static constexpr int kSize = 64, kBlock = 16, kStride = 4;

    static std::string scene_text(const std::string& mesh, float scale, float opening) {
        return R"({"tyndall": 1, "modules": ["translucency"], "render": {"image": {"antialiasing": "none"},
          "translucency": {"model": "better", "scaling": "published", "points": {"pixels": 0, "opening": )" +
               std::to_string(opening) + R"(}}}, "entities": [
          {"name": "Camera", "transform": {"translation": [0, 0, 0.06], "look_at": [0, 0, 0]},
           "camera": {"vertical_fov_deg": 24, "exposure": 1, "near_m": 0.001}},
          {"name": "Sun", "transform": {"translation": [1, 0.4, 0.2], "look_at": [0, 0, 0]},
           "directional_light": {"illuminance_lux": 1}},
          {"name": "Solid", "transform": {"scale": )" +
               std::to_string(scale) + R"(}, "mesh": {)" + mesh + R"(}, "interior": {"preset": "potato", "ior": 1}}]})";
    }

    static glm::vec3 place_of(const RenderScene& scene, int x, int y, float depth) {
        const float t = std::tan(0.5f * scene.camera.vertical_fov), far = scene.camera.near_m / depth;
        const glm::vec3 along((2.0f * (float(x) + 0.5f) / kSize - 1.0f) * t,
                              (1.0f - 2.0f * (float(y) + 0.5f) / kSize) * t, -1.0f);
        return glm::vec3(scene.camera.transform * glm::vec4(far * along, 1.0f));
    }

    static glm::dvec3 double_loop(const Surface& surface, const glm::vec3& at, const glm::vec3& to_light) {
        const Mesh& mesh = surface.mesh->mesh;
        glm::dvec3 sum(0.0);
        for (size_t t = 0; t < mesh.triangle_count(); ++t) {
            std::array<glm::vec3, 3> p, n;
            for (size_t k = 0; k < 3; ++k) {
                const uint32_t i = mesh.indices[3 * t + k];
                p[k] = glm::vec3(surface.transform * glm::vec4(mesh.positions[i], 1.0f));
                n[k] = glm::normalize(glm::mat3(surface.transform) * mesh.normals[i]);
            }
            sum += over_triangle(p, n, at, to_light, 1.0 / 700.0);
        }
        return sum / kPi;
    }

    static void compare(const RenderScene& scene, const Image& radiance, const Image& depth, double mean_limit,
                        double block_limit) {
        constexpr int kBlocks = kSize / kBlock;
        std::array<glm::dvec3, size_t(kBlocks * kBlocks)> found{}, truth{};
        std::vector<glm::ivec2> pixels;
        for (int y = kStride / 2; y < kSize; y += kStride)
            for (int x = kStride / 2; x < kSize; x += kStride)
                if (depth.at(x, y, 0) > 0.0f) pixels.emplace_back(x, y);
        std::vector<glm::dvec3> loops(pixels.size());
        const glm::vec3 to_light(scene.lights.front().transform[2]);
        parallel_for(0, pixels.size(), 4, [&](size_t first, size_t last) {
            for (size_t i = first; i < last; ++i)
                loops[i] = double_loop(scene.surfaces.front(),
                                       place_of(scene, pixels[i].x, pixels[i].y, depth.at(pixels[i].x, pixels[i].y, 0)),
                                       to_light);
        });
        glm::dvec3 all_found(0.0), all_truth(0.0);
        for (size_t i = 0; i < pixels.size(); ++i) {
            const auto block = size_t(pixels[i].y / kBlock * kBlocks + pixels[i].x / kBlock);
            const glm::dvec3 value(radiance.at(pixels[i].x, pixels[i].y, 0), radiance.at(pixels[i].x, pixels[i].y, 1),
                                   radiance.at(pixels[i].x, pixels[i].y, 2));
            found[block] += value;
            truth[block] += loops[i];
            all_found += value;
            all_truth += loops[i];
        }
        double worst = 0.0;
        for (size_t b = 0; b < found.size(); ++b)
            for (int c = 0; c < 3; ++c)
                if (truth[b][c] > 0.02 * all_truth[c] / double(found.size()))
                    worst = std::max(worst, std::abs(found[b][c] / truth[b][c] - 1.0));
        const glm::dvec3 mean = all_found / all_truth;
        std::printf("%zu pixels: mean %.4f %.4f %.4f of the double loop, worst block off by %.4f\n", pixels.size(),
                    mean.x, mean.y, mean.z, worst);
        EXPECT_GT(pixels.size(), 20u);
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(mean[c], 1.0, mean_limit);
        EXPECT_LT(worst, block_limit);
    }

    void SetUp() override {
        RendererTest::SetUp();
        const auto* test = testing::UnitTest::GetInstance()->current_test_info();
        folder_ = std::filesystem::temp_directory_path() /
                  ("tyndall_" + std::string(test->name()) + "_" + std::to_string(getpid()));
        std::filesystem::create_directories(folder_);
    }
    void TearDown() override {
        std::filesystem::remove_all(folder_);
        RendererTest::TearDown();
    }
    std::filesystem::path folder_;
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
