// The frame clock, and what the build says of itself.
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "core/build_info.h"
#include "core/clock.h"
#include "core/error.h"

namespace tyndall {
namespace {

using std::chrono::milliseconds;

TEST(FrameClock, FixedStepsIgnoreTheRealClockAndDoNotDrift) {
    FrameClock clock = FrameClock::fixed(0.1);
    EXPECT_TRUE(clock.is_fixed());
    const FrameClock::Clock::time_point start{};
    for (uint64_t i = 0; i < 1000; ++i) {
        const FrameTime time = clock.tick(start + milliseconds(i * i % 77));
        ASSERT_EQ(time.frame, i);
        ASSERT_EQ(time.time_s, static_cast<double>(i) * 0.1);
        ASSERT_EQ(time.step_s, 0.1);
    }
    clock.restart();
    EXPECT_EQ(clock.tick().time_s, 0.0);
    EXPECT_THROW((void)FrameClock::fixed(0.0), Error);
    EXPECT_THROW((void)FrameClock::fixed(-1.0), Error);
    EXPECT_THROW((void)FrameClock::fixed(std::numeric_limits<double>::quiet_NaN()), Error);
    EXPECT_THROW((void)FrameClock::fixed(std::numeric_limits<double>::infinity()), Error);
}

TEST(FrameClock, RealTimeIsFollowedAndStallsAreCutShort) {
    FrameClock clock = FrameClock::real();
    EXPECT_FALSE(clock.is_fixed());
    FrameClock::Clock::time_point now{};
    const auto after = [&](int ms) { return clock.tick(now += milliseconds(ms)); };
    EXPECT_EQ(after(500).step_s, 0.0);
    EXPECT_DOUBLE_EQ(after(20).step_s, 0.02);
    EXPECT_DOUBLE_EQ(after(5000).step_s, FrameClock::kLongestStepS);
    const FrameTime time = after(30);
    EXPECT_EQ(time.frame, 3u);
    EXPECT_DOUBLE_EQ(time.time_s, 0.02 + FrameClock::kLongestStepS + 0.03);
    clock.restart();
    EXPECT_EQ(after(40).step_s, 0.0);
    EXPECT_DOUBLE_EQ(after(40).time_s, 0.04);
}

TEST(BuildInfo, IsFilledIn) {
    const BuildInfo& info = build_info();
    for (const std::string& fact : {info.version, info.revision, info.compiler, info.preset}) {
        EXPECT_FALSE(fact.empty());
        EXPECT_EQ(fact.find('@'), std::string::npos) << fact;
    }
    EXPECT_EQ(std::count(info.version.begin(), info.version.end(), '.'), 2) << info.version;
}

}  // namespace
}  // namespace tyndall
