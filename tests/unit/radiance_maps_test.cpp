// The technique radiance_maps: what it gathers is the integral of the BSSRDF, nearer with every frame.

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <glm/gtc/matrix_transform.hpp>

#include "double_loop.h"
#include "image/compare.h"

namespace tyndall::translucency {
namespace {

class RadianceMapsTest : public DoubleLoopTest {
 protected:
    static constexpr const char* kBall = R"("primitive": "sphere", "tessellation": 96)";

    RenderScene small_ball(Engine& engine) {
        std::ofstream(folder_ / "scene.json")
            << scene_text(kBall, 0.02f, R"("radiance_maps": {"resolution": 48, "samples": 4, "light_resolution": 96})",
                          "radiance_maps");
        engine.load_scene(folder_ / "scene.json", {});
        engine.renderer().retain({"radiance"});
        return engine.extract();
    }
    static Image rendered(Engine& engine, RenderScene& scene, int frames) {
        for (int frame = 0; frame < frames; ++frame) engine.renderer().render(scene, {kSize, kSize});
        EXPECT_EQ(engine.problems(), "");
        return picture(*engine.renderer().target("radiance"));
    }

    /// After 1, 4, 16 and 60 frames; the last within the bounds, each nearer than the one before.
    void expect_the_integral(const std::string& mesh, float scale, const std::string& settings, double mean,
                             double block, const std::string& translation = "[0, 0, 0]") {
        std::ofstream(folder_ / "scene.json")
            << scene_text(mesh, scale, R"("radiance_maps": )" + settings, "radiance_maps", translation);
        Engine engine(true);
        engine.load_scene(folder_ / "scene.json", {});
        RenderScene scene = engine.extract();
        ASSERT_EQ(scene.surfaces.size(), 1u);
        engine.renderer().retain({"radiance", "scene_depth"});
        Loop loop;
        double before = 1e9;
        LoopErrors errors;
        for (int frame = 1; frame <= 60; ++frame) {
            engine.renderer().render(scene, {kSize, kSize});
            if (frame == 1) {
                const glm::vec3 to_light(scene.lights.front().transform[2]);
                const LightDepths depths(scene.surfaces.front(), to_light);
                loop = double_loop(scene, picture(*engine.renderer().target("scene_depth")),
                                   [&](const glm::vec3& p, const glm::vec3& n) { return depths.visible(p, n); });
            }
            if (frame != 1 && frame != 4 && frame != 16 && frame != 60) continue;
            std::printf("%d frames, ", frame);
            errors = errors_of(picture(*engine.renderer().target("radiance")), loop);
            EXPECT_LT(errors.relmse, before) << frame << " frames";
            before = errors.relmse;
        }
        EXPECT_EQ(engine.problems(), "");
        EXPECT_GT(errors.pixels, 20u);
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(errors.mean[c], 1.0, mean);
        EXPECT_LT(errors.worst_block, block);
    }
};

TEST_F(RadianceMapsTest, ABallIsTheDoubleLoop) {
    expect_the_integral(kBall, 0.02f, R"({"resolution": 64, "samples": 16, "light_resolution": 192})", 0.01, 0.03);
}

TEST_F(RadianceMapsTest, AThinTorusIsTheDoubleLoop) {
    std::filesystem::copy_file(paths::root() / "assets/subjects/torus.ply", folder_ / "torus.ply");
    expect_the_integral(R"("file": "torus.ply")", 0.25f,
                        R"({"resolution": 96, "samples": 12, "light_resolution": 192})", 0.01, 0.03);
}

/// Takes minutes.
TEST_F(RadianceMapsTest, DISABLED_ABunnyIsTheDoubleLoop) {
    const std::filesystem::path bunny = paths::root() / "../shared/assets/models/mitsuba_bunny.ply";
    if (!std::filesystem::exists(bunny)) GTEST_SKIP() << bunny << " is not there";
    std::filesystem::copy_file(bunny, folder_ / "bunny.ply");
    expect_the_integral(R"("file": "bunny.ply")", 0.12f, "{}", 0.01, 0.03, "[0.002, -0.0132, 0]");
}

TEST_F(RadianceMapsTest, FollowWhatMovesWithItsLight) {
    Engine still(true), moving(true);
    RenderScene scene = small_ball(still);
    const Image first = rendered(still, scene, 1), later = rendered(still, scene, 7);
    scene = small_ball(moving);
    Image followed;
    for (int frame = 0; frame < 8; ++frame) {
        RenderScene moved = scene;
        const glm::mat4 move = glm::rotate(glm::translate(glm::mat4(1.0f), glm::vec3(0.01f * float(frame), 0, 0)),
                                           0.3f * float(frame), glm::vec3(0.0f, 0.6f, 0.8f));
        for (glm::mat4* one : {&moved.surfaces[0].transform, &moved.lights[0].transform, &moved.camera.transform})
            *one = move * *one;
        moved.surfaces[0].bounds = scene.surfaces[0].bounds.transformed(move);
        followed = rendered(moving, moved, 1);
    }
    const double gathered = compare_linear(later, followed).relative_mse,
                 begun = compare_linear(later, first).relative_mse;
    std::printf("relMSE to 8 frames at rest: moving %.2e, a first frame %.2e\n", gathered, begun);
    EXPECT_LT(gathered, 0.05 * begun);
}

TEST_F(RadianceMapsTest, BeginAnewWhenTheLightChanges) {
    for (const bool brighter : {false, true}) {
        Engine old(true), fresh(true);
        RenderScene scene = small_ball(old);
        rendered(old, scene, 5);
        const auto change = [&](RenderScene& changed) {
            if (brighter)
                changed.lights[0].intensity *= 3.0f;
            else
                changed.lights[0].transform =
                    glm::rotate(glm::mat4(1.0f), 0.5f, glm::vec3(0, 1, 0)) * changed.lights[0].transform;
        };
        change(scene);
        const Image after = rendered(old, scene, 1);
        RenderScene same = small_ball(fresh);
        change(same);
        const double apart = compare_linear(rendered(fresh, same, 1), after).max_difference;
        std::printf("%s light: off by %g from a first frame\n", brighter ? "brighter" : "moved", apart);
        EXPECT_EQ(apart, 0.0) << "no trail";
    }
}

}  // namespace
}  // namespace tyndall::translucency
