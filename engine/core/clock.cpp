#include "core/clock.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/error.h"

namespace tyndall {

FrameClock FrameClock::fixed(double step_s) {
    if (!(step_s > 0.0) || !std::isfinite(step_s))
        throw Error("a fixed clock's step must be a positive number of seconds, not " + std::to_string(step_s));
    return FrameClock(step_s);
}

FrameTime FrameClock::tick(Clock::time_point now) {
    FrameTime time = next_;
    if (is_fixed()) {
        time.step_s = fixed_step_s_;
        time.time_s = static_cast<double>(time.frame) * fixed_step_s_;
    } else if (time.frame > 0) {
        const double passed_s = std::chrono::duration<double>(now - last_).count();
        time.step_s = std::clamp(passed_s, 0.0, kLongestStepS);
        time.time_s += time.step_s;
    }
    last_ = now;
    next_ = {time.frame + 1, time.time_s, 0.0};
    return time;
}

}  // namespace tyndall
