// Shadows of uneven media: how maps and boxes are laid, and that they keep still when the camera moves.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <glm/gtc/matrix_transform.hpp>
#include <span>

#include "app/engine.h"
#include "core/paths.h"
#include "image/compare.h"
#include "render/frame.h"
#include "render/seams.h"
#include "renderer_fixture.h"
#include "shadows/shadow_fit.h"

namespace tyndall {
namespace {

using participating_media::clipmap_boxes;
using participating_media::fit_shadow_map;
using participating_media::MapKind;
using participating_media::ShadowFit;
using participating_media::UnevenMedia;

constexpr int kMapSize = 64;

UnevenMedia turned_box() {
    RenderScene scene;
    Medium medium;
    medium.density = GradientDensity{};
    medium.transform = glm::translate(glm::mat4(1.0f), {1, 2, 3}) *
                       glm::rotate(glm::mat4(1.0f), 0.6f, glm::normalize(glm::vec3(1, 2, 0.5f))) *
                       glm::scale(glm::mat4(1.0f), {2, 0.5f, 1});
    scene.media.push_back(medium);
    return participating_media::uneven_media(scene.media, scene);
}

Light light_at(LightKind kind, glm::vec3 eye, glm::vec3 target) {
    Light light;
    light.kind = kind;
    light.transform = glm::inverse(glm::lookAt(eye, target, glm::vec3(0.1f, 1, 0)));
    light.outer_angle = 0.5f;
    return light;
}

/// Places in the media lie inside the map, a texel from its border, and on the ray of their u and v.
void expect_fits(const ShadowFit& fit, const UnevenMedia& media) {
    for (const glm::vec3& corner : media.corners) {
        const glm::vec3 p = glm::mix(corner, media.bounds.centre(), 1e-3f);
        const glm::vec4 at = fit.map_from_world * glm::vec4(p, 1.0f);
        ASSERT_GT(at.w, 0.0f);
        const glm::vec2 uv = glm::vec2(at) / at.w;
        const float border = 1.0f / kMapSize;
        EXPECT_GT(std::min(uv.x, uv.y), border * 0.99f);
        EXPECT_LT(std::max(uv.x, uv.y), 1.0f - border * 0.99f);
        const bool parallel = fit.kind == MapKind::parallel;
        const glm::vec3 offset = uv.x * fit.across + uv.y * fit.up;
        const glm::vec3 origin = fit.origin + (parallel ? offset : glm::vec3(0.0f));
        const glm::vec3 along = glm::normalize(fit.base + (parallel ? glm::vec3(0.0f) : offset));
        const float metres = glm::dot(p - origin, along);
        EXPECT_LT(glm::length(p - origin - metres * along), 1e-4f);
        EXPECT_GE(metres, fit.near_m - 1e-4f);
        EXPECT_LE(metres, fit.far_m + 1e-4f);
        EXPECT_NEAR(parallel ? at.z * fit.far_m : metres, metres, 1e-3f);
    }
}

TEST(ShadowFitTest, MapsHoldAllUnevenMedia) {
    const UnevenMedia media = turned_box();
    ASSERT_EQ(media.corners.size(), 8u);
    for (const Light& light :
         {light_at(LightKind::directional, {3, 9, 1}, {1, 2, 3}), light_at(LightKind::spot, {3, 9, 1}, {1, 2, 3}),
          light_at(LightKind::point, {-3, 2, 3}, {0, 0, 0})}) {
        const auto fit = fit_shadow_map(light, media, kMapSize);
        ASSERT_TRUE(fit.has_value());
        EXPECT_EQ(fit->kind, light.kind == LightKind::directional ? MapKind::parallel : MapKind::pyramid);
        expect_fits(*fit, media);
    }
}

TEST(ShadowFitTest, ALightInTheMediaLooksAllAround) {
    const auto fit = fit_shadow_map(light_at(LightKind::point, {1, 2, 3}, {0, 0, 0}), turned_box(), kMapSize);
    ASSERT_TRUE(fit.has_value());
    EXPECT_EQ(fit->kind, MapKind::octahedron);
    EXPECT_EQ(fit->near_m, 0.0f);
}

TEST(ShadowFitTest, ALightThatReachesNoMediumHasNoMap) {
    EXPECT_FALSE(fit_shadow_map(light_at(LightKind::spot, {3, 9, 1}, {3, 20, 1}), turned_box(), kMapSize).has_value());
    Light weak = light_at(LightKind::point, {30, 2, 3}, {1, 2, 3});
    weak.range_m = 5.0f;
    EXPECT_FALSE(fit_shadow_map(weak, turned_box(), kMapSize).has_value());
    EXPECT_FALSE(fit_shadow_map(weak, {}, kMapSize).has_value());
}

TEST(ShadowFitTest, ClipmapBoxesNestAndMoveInWholeVoxels) {
    const Bounds media{{-1, 0, -2}, {3, 2, 2}};
    constexpr int kVoxels = 32, kLevels = 3;
    for (const glm::vec3 camera : {glm::vec3(0, 1, 0), glm::vec3(0.71f, 1.3f, -0.9f), glm::vec3(50, -9, 0)}) {
        const std::vector<Bounds> boxes = clipmap_boxes(media, camera, kLevels, kVoxels);
        ASSERT_EQ(boxes.size(), 3u);
        EXPECT_EQ(boxes.back().low, media.low);
        EXPECT_EQ(boxes.back().high, media.high);
        for (const Bounds& box : boxes) {
            EXPECT_TRUE(media.contains(box.low + 1e-5f) && media.contains(box.high - 1e-5f));
            const glm::vec3 voxels = (box.low - media.low) / (box.size() / float(kVoxels));
            EXPECT_LT(glm::length(voxels - glm::round(voxels)), 1e-3f);
        }
    }
    const auto here = clipmap_boxes(media, {0, 1, 0}, kLevels, kVoxels);
    const auto a_bit_on = clipmap_boxes(media, {0.01f, 1.002f, -0.01f}, kLevels, kVoxels);
    for (size_t i = 0; i < here.size(); ++i) EXPECT_EQ(here[i].low, a_bit_on[i].low);
}

/// Asks the light-transmittance seam for places on a plane through the smoke and the floor below.
class ProbePass final : public Pass {
 public:
    [[nodiscard]] std::string_view name() const override { return "test.shadow_probe"; }
    void declare(PassDeclaration& declaration) override {
        declaration.stage(Stage::lighting)
            .reads("media_shadows", "asked for")
            .writes("shadow_probe", {.format = gpu::Format::rgba32f}, "transmittance")
            .keep();
    }
    void execute(PassContext& context) override {
        const gpu::Program& program = context.frame().shaders.program(
            {.name = "test.shadow_probe", .fragment = "media_test/media_shadow_probe.frag"});
        context.bind_targets();
        program.use();
        bind_frame(program, context.frame());
        context.frame().seams.bind(Seam::light_transmittance, program, context);
        program.set("low", glm::vec3(-0.4f, 0.01f, 0.0f));
        program.set("across", glm::vec3(0.8f, 0.0f, -0.1f));
        program.set("up", glm::vec3(0.0f, 0.99f, 0.0f));
        gpu::draw_fullscreen();
    }
};

class MediaShadowsTest : public RendererTest {
 protected:
    void TearDown() override {
        EXPECT_EQ(engine_->problems(), "");
        const std::array<Pass*, 1> passes{&probe_};
        engine_->renderer().remove_passes(passes);
        engine_.reset();
        RendererTest::TearDown();
    }
    void load(const char* file, const char* method, Assignments changes = {}) {
        if (!engine_) {
            engine_ = std::make_unique<Engine>(true);
            engine_->renderer().shaders().add_folder("media_test", paths::root() / "tests/unit");
        } else {
            const std::array<Pass*, 1> passes{&probe_};
            engine_->renderer().remove_passes(passes);
        }
        changes.push_back({"/render/participating_media/shadows/method", method});
        engine_->load_scene(paths::root() / file, changes);
        engine_->renderer().add_pass(&probe_);
        scene_ = engine_->extract();
    }
    Image probe() {
        engine_->renderer().retain({"shadow_probe"});
        engine_->renderer().render(scene_, {64, 48});
        return picture(*engine_->renderer().target("shadow_probe"));
    }
    ProbePass probe_;
    std::unique_ptr<Engine> engine_;
    RenderScene scene_;
};

constexpr const char* kSmoke = "assets/scenes/smoke.json";

TEST_F(MediaShadowsTest, ShadowsKeepStillWhenTheCameraMoves) {
    for (const char* method : {R"("opacity_map")", R"("clipmap")"}) {
        load(kSmoke, method,
             {{"/render/participating_media/shadows/levels", "3"},
              {"/render/participating_media/shadows/voxels", "32"}});
        scene_.camera.transform = test::looking({0, 0.9f, 2.4f}, {0, 0.5f, 0});
        const Image here = probe();
        scene_.camera.transform = test::looking({0.002f, 0.901f, 2.398f}, {0, 0.5f, 0});  // a fraction of a voxel
        EXPECT_EQ(compare_linear(here, probe()).max_difference, 0.0) << method;
        scene_.camera.transform = test::looking({-0.9f, 0.2f, -0.7f}, {0, 0.5f, 0});  // to the smoke's other side
        const auto moved = compare_linear(here, probe());
        std::printf("%s: camera on the other side: relMSE %.6f, max %.4f\n", method, moved.relative_mse,
                    moved.max_difference);
        const bool levels_move = std::string_view(method) == R"("clipmap")";  // finer voxels elsewhere
        EXPECT_LE(moved.relative_mse, levels_move ? 0.0005 : 0.0);
    }
}

TEST_F(MediaShadowsTest, MapsAreThoseOfTheMarch) {
    load(kSmoke, R"("march")", {{"/render/participating_media/light_steps", "128"}});
    const Image marched = probe();
    EXPECT_LT(*std::ranges::min_element(std::span(marched.floats())), 0.1f);
    for (const char* method : {R"("opacity_map")", R"("fourier_map")", R"("clipmap")", R"("auto")"}) {
        load(kSmoke, method);
        const double error = compare_linear(marched, probe()).relative_mse;
        std::printf("%s: relMSE %.6f\n", method, error);
        EXPECT_LT(error, 0.001) << method;
    }
}

TEST_F(MediaShadowsTest, WindMakesTheMapsAgain) {
    load("assets/scenes/smoke_wind.json", R"("auto")");
    const Image now = probe();
    scene_.time_s = 1.0;
    const Image later = probe();
    EXPECT_GT(compare_linear(now, later).relative_mse, 0.001);
    scene_.time_s = 0.0;
    EXPECT_EQ(compare_linear(now, probe()).max_difference, 0.0);
}

}  // namespace
}  // namespace tyndall
