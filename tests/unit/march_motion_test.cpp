// The ray march from frame to frame: moving lights and cameras, cuts.

#include <gtest/gtest.h>

#include <cstdio>
#include <functional>

#include "image/compare.h"
#include "march_fixture.h"

namespace tyndall {
namespace {

class MarchMotionTest : public MarchTest {
 protected:
    void compare_motion(const char* what, const Assignments& changes, const std::function<void(int)>& move);
};

/// The error of a frame after motion and of one at rest in the same place, against many steps at full resolution.
void MarchMotionTest::compare_motion(const char* what, const Assignments& changes,
                                     const std::function<void(int)>& move) {
    constexpr int kFrames = 12;
    const auto last_of = [&](const Assignments& changed, bool still) {
        load(changed);
        Image last;
        for (int i = 0; i < kFrames; ++i) {
            move(still ? kFrames - 1 : i);
            cut_ = cut_ && !still;
            last = frame();
        }
        return last;
    };
    const Image moving = last_of(changes, false), still = last_of(changes, true);
    load({{"/render/participating_media/steps", "256"}, {"/render/participating_media/filter", "false"}});
    move(kFrames - 1);
    const Image truth = frame();
    const double error = compare_linear(truth, moving).relative_mse,
                 at_rest = compare_linear(truth, still).relative_mse;
    std::printf("%s: relMSE moving %.6f, at rest %.6f\n", what, error, at_rest);
    EXPECT_LE(error, 2.0 * at_rest);
    EXPECT_LT(at_rest, 0.003);
}

TEST_F(MarchMotionTest, MotionLeavesNoTrail) {
    size_ = {160, 90};
    for (const char* resolution : {"full", "half"}) {
        const Assignments changes{{"/render/participating_media/resolution", quoted(resolution)},
                                  {"/render/participating_media/steps", "12"},
                                  {"/render/participating_media/temporal", "true"}};
        const std::string mode = resolution;
        compare_motion((mode + ", light").c_str(), changes, [this](int i) {
            scene_.lights[0].transform[3] = glm::vec4(-1.5f + 0.2f * float(i), 6.5f, -1.0f, 1.0f);
        });
        compare_motion((mode + ", flicker").c_str(), changes,
                       [this](int i) { scene_.lights[0].intensity = glm::vec3(i % 2 == 0 ? 400.0f : 100.0f); });
        compare_motion((mode + ", camera").c_str(), changes, [this](int i) {
            scene_.camera.transform = test::looking({-1.2f + 0.2f * float(i), 2.6f, 8.0f}, {0, 2.6f, -1});
        });
        compare_motion((mode + ", turning camera").c_str(), changes, [this](int i) {
            scene_.camera.transform = test::looking({0, 2.6f, 8.0f}, {-2.0f + 0.4f * float(i), 2.6f, -1});
        });
        compare_motion((mode + ", cut").c_str(), changes, [this](int i) {
            const bool last = i == 11;
            scene_.camera.transform = test::looking({last ? 3.0f : 0.0f, 2.6f, 8.0f}, {0, 2.6f, -1});
            cut_ = last;
        });
    }
}

TEST_F(MarchMotionTest, WithoutHistoryFramesAreTheSame) {
    size_ = {160, 90};
    load({{"/render/participating_media/resolution", "\"half\""}});
    const Image first = frame();
    (void)frame();
    EXPECT_EQ(compare_linear(first, frame()).max_difference, 0.0);
}

}  // namespace
}  // namespace tyndall
