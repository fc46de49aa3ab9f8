#include "frame_timing.h"

#include <sys/resource.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace tyndall {
namespace {

rusage usage_so_far() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return usage;
}

double processor_ms() {
    const rusage usage = usage_so_far();
    const auto ms = [](const timeval& t) {
        return 1e3 * static_cast<double>(t.tv_sec) + 1e-3 * static_cast<double>(t.tv_usec);
    };
    return ms(usage.ru_utime) + ms(usage.ru_stime);
}

/// The camera, turned a little more each frame.
std::optional<View> turned(const glm::mat4& home, int frame, bool orbit) {
    if (!orbit || frame == 0) return std::nullopt;
    const float angle = 0.02f * static_cast<float>(frame);
    glm::mat4 turn(1.0f);
    turn[0] = {std::cos(angle), 0.0f, -std::sin(angle), 0.0f};
    turn[2] = {std::sin(angle), 0.0f, std::cos(angle), 0.0f};
    return View{home * turn, 0.0f};
}

/// Calls `before` and `after` around each timed frame, after the warm-up.
template <class Before, class After>
void run_frames(Engine& engine, const TimingPlan& plan, Before before, After after) {
    for (int i = 0; i < plan.warmup; ++i) engine.frame(1.0 / 60.0, plan.size);
    const glm::mat4 home = engine.extract().camera.transform;
    for (int i = 0; i < plan.frames; ++i) {
        before();
        engine.frame(1.0 / 60.0, plan.size, turned(home, i, plan.orbit));
        after();
    }
}

}  // namespace

double median(std::vector<double> values) {
    if (values.empty()) return 0.0;
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

std::string_view timing_method() {
    return gpu::Timer::method();
}

FrameTime time_frames(Engine& engine, const TimingPlan& plan) {
    std::vector<double> whole, processor;
    engine.renderer().set_timing(false);
    gpu::Timer timer;
    double start = 0.0;
    run_frames(
        engine, plan,
        [&] {
            gpu::finish();
            start = processor_ms();
            timer.begin();
        },
        [&] {
            timer.end();
            gpu::finish();
            whole.push_back(timer.milliseconds());
            processor.push_back(processor_ms() - start);
        });
    if (whole.empty()) return {};
    return {median(whole), *std::ranges::min_element(whole), median(processor)};
}

std::vector<PassTiming> time_passes(Engine& engine, const TimingPlan& plan) {
    std::map<std::string, std::vector<double>> times;
    std::vector<PassTiming> passes;
    engine.renderer().set_timing(true);
    run_frames(
        engine, plan, [] {},
        [&] {
            gpu::finish();
            for (const PassTime& pass : engine.renderer().statistics().passes) {
                if (pass.milliseconds < 0.0) continue;
                if (times[pass.name].empty()) passes.push_back({pass.name});
                times[pass.name].push_back(pass.milliseconds);
            }
        });
    for (PassTiming& pass : passes) {
        pass.median = median(times[pass.name]);
        pass.least = *std::ranges::min_element(times[pass.name]);
    }
    return passes;
}

double peak_memory_mb() {
    return static_cast<double>(usage_so_far().ru_maxrss) / 1000.0;
}

}  // namespace tyndall
