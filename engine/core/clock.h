#pragma once
/// The time of the frame loop.

#include <chrono>
#include <cstdint>

namespace tyndall {

/// One frame's time.
struct FrameTime {
    uint64_t frame = 0;   ///< counts from 0
    double time_s = 0.0;  ///< since the clock started
    double step_s = 0.0;  ///< how far to advance what moves: since the frame before; 0 in a real clock's first frame
};

/// Tells each frame its time: as it really passes, or in fixed steps so that captures repeat exactly.
class FrameClock {
 public:
    using Clock = std::chrono::steady_clock;
    /// A frame that took longer than this (a stall, a debugger, a reload) counts as this long: motion does not jump.
    static constexpr double kLongestStepS = 0.1;

    /// Follows the computer's clock.
    [[nodiscard]] static FrameClock real() { return FrameClock(0.0); }
    /// Advances by `step_s` (> 0; throws Error otherwise) each frame, however long it takes. Frame n is at
    /// n * step_s, without drift.
    [[nodiscard]] static FrameClock fixed(double step_s);

    [[nodiscard]] bool is_fixed() const { return fixed_step_s_ > 0.0; }
    /// The time of the next frame. Call it once a frame; `now` is for tests.
    FrameTime tick(Clock::time_point now = Clock::now());
    /// The next frame is frame 0 at time 0.
    void restart() { next_ = {}; }

 private:
    explicit FrameClock(double fixed_step_s) : fixed_step_s_(fixed_step_s) {}

    double fixed_step_s_;  ///< 0 = real
    FrameTime next_;       ///< of a real clock: its time is that of the last frame
    Clock::time_point last_;
};

}  // namespace tyndall
