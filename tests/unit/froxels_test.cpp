// The solver froxels from frame to frame: moving lights and cameras, and what is drawn before the background.

#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <functional>
#include <glm/gtc/matrix_transform.hpp>

#include "app/engine.h"
#include "core/paths.h"
#include "gpu_fixture.h"
#include "image/compare.h"
#include "render/frame.h"
#include "render/seams.h"
#include "renderer_fixture.h"

namespace tyndall {
namespace {

double relmse(const Image& reference, const Image& test) {
    return compare_linear(reference, test).relative_mse;
}

constexpr glm::ivec2 kSize{160, 90};

/// Asks the media-segment seam for a place at one depth on each pixel's ray: a pane of glass in front of the scene.
class ProbePass final : public Pass {
 public:
    float metres = 5.0f;
    [[nodiscard]] std::string_view name() const override { return "test.media_probe"; }
    void declare(PassDeclaration& declaration) override {
        declaration.stage(Stage::transparent)
            .reads("media_in_scatter", "of the whole ray")
            .writes("media_probe", {.format = gpu::Format::rgba32f}, "as far as the pane")
            .keep();
    }
    void execute(PassContext& context) override {
        const gpu::Program& program =
            context.frame().shaders.program({.name = "test.media_probe", .fragment = "media_test/media_probe.frag"});
        context.bind_targets();
        program.use();
        bind_frame(program, context.frame());
        context.frame().seams.bind(Seam::media_segment, program, context);
        program.set("metres", metres);
        gpu::draw_fullscreen();
    }
};

class FroxelsTest : public RendererTest {
 protected:
    void TearDown() override {
        EXPECT_EQ(engine_->problems(), "");
        engine_.reset();
        RendererTest::TearDown();
    }
    /// s1_fog_spot with froxels for its 160x90 pixels, and more changes.
    void load(Assignments changes = {}) {
        changes.insert(changes.begin(), {{"/entities/Fog/medium/solver", R"("froxels")"},
                                         {"/render/participating_media/froxels/width", "40"},
                                         {"/render/participating_media/froxels/height", "23"}});
        if (!engine_) engine_ = std::make_unique<Engine>(true);
        engine_->load_scene(paths::root() / "assets/scenes/s1_fog_spot.json", changes);
        scene_ = engine_->extract();
        frame_ = 0;
    }
    Image frame(std::string_view target = "media_in_scatter") {
        scene_.camera_cut = frame_ == 0;
        scene_.frame = frame_++;
        engine_->renderer().retain({std::string(target)});
        engine_->renderer().render(scene_, kSize);
        return picture(*engine_->renderer().target(target));
    }
    Image frames(int count, const std::function<void(int)>& move) {
        Image last;
        for (int i = 0; i < count; ++i) {
            move(i);
            last = frame();
        }
        return last;
    }
    /// The error of a frame after motion, of one at rest at the same place, both against many samples without history.
    void compare_motion(const char* what, const std::function<void(int)>& move) {
        constexpr int kFrames = 12;
        load();
        const Image moving = frames(kFrames, move);
        load();
        const Image still = frames(kFrames, [&](int) { move(kFrames - 1); });
        load({{"/render/participating_media/froxels/history", "false"},
              {"/render/participating_media/froxels/samples_alone", "64"}});
        const Image truth = frames(1, [&](int) { move(kFrames - 1); });
        const double error = relmse(truth, moving), at_rest = relmse(truth, still);
        std::printf("%s: relMSE moving %.6f, at rest %.6f\n", what, error, at_rest);
        EXPECT_LE(error, 2.0 * at_rest);
        EXPECT_LT(at_rest, 0.02);
    }

    std::unique_ptr<Engine> engine_;
    RenderScene scene_;
    uint64_t frame_ = 0;
};

TEST_F(FroxelsTest, AMovingLightLeavesNoTrail) {
    compare_motion("light", [this](int i) {
        scene_.lights[0].transform[3] = glm::vec4(-1.5f + 0.2f * float(i), 6.5f, -1.0f, 1.0f);
    });
}

TEST_F(FroxelsTest, ALightThatFlickersLeavesNoTrail) {
    compare_motion("flicker", [this](int i) { scene_.lights[0].intensity = glm::vec3(i % 2 == 0 ? 400.0f : 100.0f); });
}

TEST_F(FroxelsTest, AMovingCameraLeavesNoTrail) {
    compare_motion("camera", [this](int i) {
        scene_.camera.transform = test::looking({-1.2f + 0.2f * float(i), 2.6f, 8.0f}, {0, 2.6f, -1});
    });
}

TEST_F(FroxelsTest, WithoutHistoryFramesAreTheSame) {
    load({{"/render/participating_media/froxels/history", "false"}});
    const Image first = frame();
    (void)frame();
    EXPECT_EQ(compare_linear(first, frame()).max_difference, 0.0);
}

TEST_F(FroxelsTest, APaneSeesWhatAWallInItsPlaceWouldSee) {
    ProbePass probe;
    for (const char* solver : {R"("froxels")", R"("ray_marched")"}) {
        for (const float metres : {7.5f, 8.5f, 9.5f, 11.0f}) {
            const Assignments chosen{{"/entities/Fog/medium/solver", solver},
                                     {"/render/participating_media/steps", "64"},
                                     {"/render/participating_media/froxels/samples_alone", "16"}};
            load(chosen);
            engine_->renderer().shaders().add_folder("media_test", paths::root() / "tests/unit");
            engine_->renderer().add_pass(&probe);
            probe.metres = metres;
            const Image pane = frame("media_probe");
            const std::array<Pass*, 1> passes{&probe};
            engine_->renderer().remove_passes(passes);
            load(chosen);
            Surface wall = scene_.surfaces.front();
            wall.mesh = test::plane_mesh();
            wall.transform = scene_.camera.transform * test::translated({0, 0, -metres}) *
                             glm::rotate(glm::mat4(1.0f), 1.5707963f, glm::vec3(1, 0, 0)) * test::scaled({30, 1, 30});
            wall.bounds = wall.mesh->mesh.bounds.transformed(wall.transform);
            wall.casts_shadow = false;
            scene_.surfaces.push_back(wall);
            const LinearDifference difference = compare_linear(frame(), pane);
            std::printf("%s at %.1f m: relMSE %.6f, mean ratio %.4f\n", solver, double(metres), difference.relative_mse,
                        difference.mean_ratio);
            EXPECT_LT(difference.relative_mse, 0.015);
            EXPECT_NEAR(difference.mean_ratio, 1.0, 0.02);
        }
    }
}

}  // namespace
}  // namespace tyndall
