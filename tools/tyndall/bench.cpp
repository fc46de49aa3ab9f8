#include <fmt/format.h>

#include <chrono>

#include "app/capture.h"
#include "commands.h"
#include "frame_timing.h"

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

double now_ms() {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

void print_passes(Engine& engine, const TimingPlan& plan) {
    fmt::print("{:36} {:>9} {:>9}\n", "pass", "median ms", "least ms");
    double sum = 0.0;
    for (const PassTiming& pass : time_passes(engine, plan)) {
        sum += pass.median;
        fmt::print("{:36} {:9.2f} {:9.2f}\n", pass.name, pass.median, pass.least);
    }
    fmt::print("{:36} {:9.2f}   (timed by {})\n", "sum of passes", sum, timing_method());
}

int bench(const BenchOptions& options) {
    const double start = now_ms();
    const auto context = platform::create_headless_context();
    Engine engine(true, options.scene.ocio);
    engine.load_scene(options.file, options.scene.changes());
    engine.select_camera(options.scene.camera);
    const glm::ivec2 size = parse_size(options.size);
    const TimingPlan plan{size, options.frames, options.warmup, options.orbit};
    engine.frame(0.0, size);
    gpu::finish();
    const double first = now_ms() - start;
    if (options.graph) {
        fmt::print("{}", engine.renderer().graph().dot());
        return 0;
    }
    fmt::print("{} at {}x{}, {}, on {}\n", options.file, size.x, size.y, engine.options().path,
               context->gl_info().renderer);
    fmt::print("start to first frame {:.0f} ms\n", first);
    print_passes(engine, plan);
    const FrameTime whole = time_frames(engine, plan);
    const FrameStatistics statistics = engine.renderer().statistics();
    fmt::print("{:36} {:9.2f} {:9.2f}   (median of {}, timed by {}; {:.2f} ms of processors' time)\n", "whole frame",
               whole.whole, whole.least, options.frames, timing_method(), whole.processor);
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
