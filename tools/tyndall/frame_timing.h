#pragma once
/// Timing frames: what bench and measure share, and say of how they did it.

#include <string>
#include <string_view>
#include <vector>

#include "app/engine.h"

namespace tyndall {

/// What to time. The scene is loaded and its camera chosen.
struct TimingPlan {
    glm::ivec2 size{1280, 720};
    int frames = 20;
    int warmup = 3;      ///< frames before those, that are not timed
    bool orbit = false;  ///< turns the camera a little each frame: no cached shadow cascade fits
};

/// Medians over the frames of a plan, milliseconds.
struct FrameTime {
    double whole = 0;      ///< from the first to the last command of a frame, by timing_method()
    double least = 0;      ///< the quickest frame's
    double processor = 0;  ///< time of all processors in a frame: what other programs on the machine change least
};

/// One pass, milliseconds.
struct PassTiming {
    std::string name;
    double median = 0;
    double least = 0;
};

[[nodiscard]] double median(std::vector<double> values);

/// How frames and passes are timed: GL timer queries, or glFinish and the CPU clock where those lie.
[[nodiscard]] std::string_view timing_method();

/// Frames as a whole, without the passes' clocks, which hold a GPU up.
[[nodiscard]] FrameTime time_frames(Engine& engine, const TimingPlan& plan);
/// Each pass, in the order of the frame.
[[nodiscard]] std::vector<PassTiming> time_passes(Engine& engine, const TimingPlan& plan);

/// The most memory that the process had at once, in MB.
[[nodiscard]] double peak_memory_mb();

}  // namespace tyndall
