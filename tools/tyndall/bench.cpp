#include <fmt/format.h>
#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>

#include "app/capture.h"
#include "commands.h"
#include "core/paths.h"

namespace tyndall {
namespace {

struct BenchOptions {
    SceneOptions scene;
    std::string file = "assets/chapel/chapel.json";
    std::string size = "1280x720";
    int frames = 20;
    int warmup = 3;
    bool graph = false, orbit = false;
};

double median(std::vector<double> values) {
    if (values.empty()) return 0.0;
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

double now_ms() {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// The most memory that the process had at once, in MB.
double peak_memory_mb() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<double>(usage.ru_maxrss) / 1000.0;
}

/// The camera, turned a little more each frame: no cached shadow cascade fits.
std::optional<View> turned(const glm::mat4& home, int frame, bool orbit) {
    if (!orbit || frame == 0) return std::nullopt;
    const float angle = 0.02f * static_cast<float>(frame);
    glm::mat4 turn(1.0f);
    turn[0] = {std::cos(angle), 0.0f, -std::sin(angle), 0.0f};
    turn[2] = {std::sin(angle), 0.0f, std::cos(angle), 0.0f};
    return View{home * turn, 0.0f};
}

/// Frames timed as a whole, without the per-pass clocks that hold the GPU up.
double frame_time(Engine& engine, const BenchOptions& options, glm::ivec2 size) {
    std::vector<double> times;
    engine.renderer().set_timing(false);
    const glm::mat4 home = engine.extract().camera.transform;
    for (int i = 0; i < options.frames; ++i) {
        const double start = now_ms();
        engine.frame(1.0 / 60.0, size, turned(home, i, options.orbit));
        gpu::finish();
        times.push_back(now_ms() - start);
    }
    return median(times);
}

void print_passes(Engine& engine, const BenchOptions& options, glm::ivec2 size) {
    std::map<std::string, std::vector<double>> times;
    std::vector<std::string> order;
    engine.renderer().set_timing(true);
    const glm::mat4 home = engine.extract().camera.transform;
    for (int i = 0; i < options.frames; ++i) {
        engine.frame(1.0 / 60.0, size, turned(home, i, options.orbit));
        gpu::finish();
        for (const PassTime& pass : engine.renderer().statistics().passes) {
            if (pass.milliseconds < 0.0) continue;
            if (times[pass.name].empty()) order.push_back(pass.name);
            times[pass.name].push_back(pass.milliseconds);
        }
    }
    fmt::print("{:36} {:>9} {:>9}\n", "pass", "median ms", "least ms");
    double sum = 0.0;
    for (const std::string& name : order) {
        const double middle = median(times[name]);
        sum += middle;
        fmt::print("{:36} {:9.2f} {:9.2f}\n", name, middle, *std::min_element(times[name].begin(), times[name].end()));
    }
    fmt::print("{:36} {:9.2f}   (timed by {})\n", "sum of passes", sum, gpu::Timer::method());
}

int bench(const BenchOptions& options) {
    const double start = now_ms();
    const auto context = platform::create_headless_context();
    Engine engine(true, options.scene.ocio);
    engine.load_scene(options.file, options.scene.changes());
    engine.select_camera(options.scene.camera);
    const glm::ivec2 size = parse_size(options.size);
    engine.frame(0.0, size);
    gpu::finish();
    const double first = now_ms() - start;
    if (options.graph) {
        fmt::print("{}", engine.renderer().graph().dot());
        return 0;
    }
    for (int i = 0; i < options.warmup; ++i) engine.frame(1.0 / 60.0, size);
    gpu::finish();
    fmt::print("{} at {}x{}, {}, on {}\n", options.file, size.x, size.y, engine.options().path,
               context->gl_info().renderer);
    fmt::print("start to first frame {:.0f} ms\n", first);
    print_passes(engine, options, size);
    const double whole = frame_time(engine, options, size);
    const FrameStatistics statistics = engine.renderer().statistics();
    fmt::print("{:36} {:9.2f}   (median of {}, glFinish and CPU clock)\n", "whole frame", whole, options.frames);
    fmt::print("triangles {}, targets {:.1f} MB, all textures {:.1f} MB, peak memory {:.0f} MB\n", statistics.triangles,
               static_cast<double>(statistics.target_bytes) / 1e6,
               static_cast<double>(gpu::alive().texture_bytes) / 1e6, peak_memory_mb());
    return 0;
}

}  // namespace

void add_bench(CLI::App& app, Command& command) {
    auto options = std::make_shared<BenchOptions>();
    CLI::App* sub = app.add_subcommand("bench", "Time a scene's passes, and say how they were timed");
    sub->add_option("scene", options->file, "Scene file")->capture_default_str();
    sub->add_option("--size", options->size, "WIDTHxHEIGHT")->capture_default_str();
    sub->add_option("--frames", options->frames, "Frames to time")->capture_default_str()->check(CLI::Range(1, 100000));
    sub->add_option("--warmup", options->warmup, "Frames before that")
        ->capture_default_str()
        ->check(CLI::Range(0, 100000));
    sub->add_flag("--orbit", options->orbit, "Turn the camera from frame to frame");
    sub->add_flag("--graph", options->graph, "Print the frame graph for Graphviz instead");
    options->scene.add_to(*sub);
    sub->callback([options, &command] { command = [options] { return bench(*options); }; });
}

}  // namespace tyndall
