#pragma once
// A scene of fog under a lamp, marched, and pictures of what the march finds.

#include <memory>
#include <string>

#include "app/engine.h"
#include "core/paths.h"
#include "gpu_fixture.h"
#include "renderer_fixture.h"

namespace tyndall {

inline std::string quoted(const std::string& text) {
    return '"' + text + '"';
}

class MarchTest : public RendererTest {
 protected:
    void TearDown() override {
        EXPECT_EQ(engine_->problems(), "");
        engine_.reset();
        RendererTest::TearDown();
    }
    void load(Assignments changes) {
        changes.insert(changes.begin(), {"/entities/Fog/medium/solver", quoted("ray_marched")});
        if (!engine_) engine_ = std::make_unique<Engine>(true);
        engine_->load_scene(paths::root() / "assets/scenes/s1_fog_spot.json", changes);
        scene_ = engine_->extract();
        frame_ = 0;
        cut_ = false;
    }
    Image frame(std::string_view target = "media_in_scatter") {
        scene_.camera_cut = frame_ == 0 || cut_;
        scene_.frame = frame_++;
        engine_->renderer().retain({std::string(target)});
        engine_->renderer().render(scene_, size_);
        return picture(*engine_->renderer().target(target));
    }
    std::unique_ptr<Engine> engine_;
    RenderScene scene_;
    uint64_t frame_ = 0;
    glm::ivec2 size_{320, 180};
    bool cut_ = false;
};

}  // namespace tyndall
