// trace and merge: pictures by the reference path tracer.

#include <fmt/format.h>
#include <unistd.h>

#include <atomic>
#include <charconv>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "commands.h"
#include "core/error.h"
#include "core/log.h"
#include "core/parallel.h"
#include "image/image_io.h"
#include "reference/trace.h"
#include "trace_recipe.h"
#include "traced_reference.h"

namespace tyndall {
namespace fs = std::filesystem;
namespace {

using reference::Film;
using reference::Tracer;
using Clock = std::chrono::steady_clock;

std::atomic<bool> interrupted{false};

double seconds_since(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

struct TraceOptions {
    SceneOptions scene;
    std::string file, size = "640x360", out, shard, orders;
    int64_t spp = 0;
    double time_s = 0.0, noise = 0.0, checkpoint_s = 60.0;
    int batch = 0, threads = 0;
    uint32_t seed = 0;
    float clamp = 0.0f;
    bool resume = false, single = false, components = false, no_surfaces = false, no_media = false, png = false;

    [[nodiscard]] fs::path output() const {
        return out.empty() ? fs::path(fs::path(file).stem().string() + ".exr") : fs::path(out);
    }
};

/// "A/B" with 1 <= A <= B, or "A..B", "A", "A.." with A <= B.
bool parse_pair(const std::string& text, std::string_view between, int64_t& a, int64_t& b) {
    const char* end = text.data() + text.size();
    auto [at, error] = std::from_chars(text.data(), end, a);
    if (error != std::errc{} || a < 0) return false;
    const std::string_view rest(at, static_cast<size_t>(end - at));
    if (!rest.starts_with(between)) return false;
    const char* second = at + between.size();
    if (second == end) return true;
    const auto last = std::from_chars(second, end, b);
    return last.ec == std::errc{} && last.ptr == end && a <= b;
}

/// The batches that this run is to trace: every `step`th from `first` on, below `end`.
struct Share {
    int64_t first = 0, step = 1, end = std::numeric_limits<int64_t>::max();
};

Share share_of(const TraceOptions& options, int batch) {
    Share share;
    if (options.spp > 0) share.end = (options.spp + batch - 1) / batch;
    if (options.shard.empty()) return share;
    int64_t part = 0, parts = 0;
    if (!parse_pair(options.shard, "/", part, parts) || part < 1 || parts < 1)
        throw Error("'" + options.shard + "' is no shard (expected I/N with I from 1 to N, such as 2/8)");
    share.first = part - 1;
    share.step = parts;
    return share;
}

reference::TraceSettings settings_of(const TraceOptions& options) {
    reference::TraceSettings settings;
    settings.size = parse_size(options.size);
    settings.seed = options.seed;
    settings.clamp = options.clamp;
    settings.components = options.components;
    settings.surfaces_scatter = !options.no_surfaces;
    settings.media_scatter = !options.no_media;
    settings.batch = options.batch > 0 ? options.batch : batch_for(options.spp);
    if (options.single) settings.max_order = 1;
    if (options.orders.empty()) return settings;
    int64_t low = 0, high = std::numeric_limits<int>::max();
    if (options.single || !parse_pair(options.orders, "..", low, high))
        throw Error("'" + options.orders +
                    "' is no range of orders (expected A..B or A.., without --single-scattering)");
    settings.min_order = static_cast<int>(low);
    settings.max_order = static_cast<int>(std::min<int64_t>(high, std::numeric_limits<int>::max()));
    return settings;
}

/// Traces a film until it is good enough, keeping what there is on disk.
class TraceRun {
 public:
    TraceRun(const TraceOptions& options) : options_(options), engine_(false, options.scene.ocio) {
        const RenderScene& scene =
            load_for_tracing(engine_, options.file, options.scene.changes(), options.scene.camera);
        reference::TraceSettings settings = settings_of(options);
        if (options.resume && fs::exists(options.output())) {
            film_ = Film::load(options.output());
            settings.batch = film_->batch();
        }
        share_ = share_of(options, settings.batch);
        tracer_ = std::make_unique<Tracer>(scene, settings);
        Film fresh = tracer_->film(trace_recipe(engine_, options.scene.camera, settings));
        if (film_) fresh.merge(*film_);  // throws when it is another picture's
        resumed_ = fresh.samples();
        film_ = std::move(fresh);
        if (settings.clamp > 0.0f)
            log::warning("samples above {} times white are clamped: the picture loses their light", settings.clamp);
    }

    int run() {
        save();  // a place that cannot be written is better known before than after
        int64_t batch = share_.first;
        bool complete = false;
        while (!interrupted && !complete) {
            while (film_->has(batch)) batch += share_.step;
            complete = batch >= share_.end || good_enough();
            if (!complete)
                complete = !tracer_->add_batch(*film_, batch, [] { return interrupted.load(); }) && !interrupted;
            show(batch);
            if (seconds_since(saved_) > options_.checkpoint_s) checkpoint();
        }
        save();
        if (options_.png) save_display();
        finish_line();
        return interrupted ? 130 : 0;
    }

 private:
    [[nodiscard]] bool good_enough() const {
        if (film_->batches() == 0) return false;
        if (options_.time_s > 0.0 && seconds_since(start_) >= options_.time_s) return true;
        return options_.noise > 0.0 && film_->batches() >= 4 && film_->noise() <= options_.noise;
    }

    /// Seconds that are left, by what the run was asked for; negative when nobody knows.
    [[nodiscard]] double time_left(int64_t batch) const {
        const double spent = seconds_since(start_);
        const auto done = static_cast<double>(film_->samples() - resumed_);
        double left = -1.0;
        const auto sooner = [&](double seconds) { left = left < 0.0 ? seconds : std::min(left, seconds); };
        if (options_.time_s > 0.0) sooner(std::max(options_.time_s - spent, 0.0));
        if (done <= 0.0) return left;
        if (options_.spp > 0)
            sooner(spent / done * film_->batch() *
                   static_cast<double>(std::max<int64_t>(0, (share_.end - 1 - batch) / share_.step)));
        if (options_.noise > 0.0 && std::isfinite(film_->noise())) {
            const double wanted =
                static_cast<double>(film_->samples()) * std::pow(film_->noise() / options_.noise, 2.0);
            sooner(std::max(0.0, (wanted - static_cast<double>(film_->samples())) * spent / done));
        }
        return left;
    }

    void show(int64_t batch) {
        const bool terminal = isatty(STDERR_FILENO) != 0;
        if (seconds_since(shown_) < (terminal ? 0.2 : 10.0)) return;
        shown_ = Clock::now();
        const double spent = seconds_since(start_), left = time_left(batch);
        const double share = left >= 0.0 ? spent / std::max(spent + left, 1e-9) : 0.0;
        const std::string bar(static_cast<size_t>(std::lround(share * 24.0)), '#');
        fmt::print(stderr, "{}[{:24}] {} samples, noise {:.2f} %, {:.0f} s{}{}", terminal ? "\r" : "", bar,
                   film_->samples(), 100.0 * film_->noise(), spent,
                   left >= 0.0 ? fmt::format(", {:.0f} s left", left) : "", terminal ? "   " : "\n");
        line_open_ = terminal;
    }

    void finish_line() {
        if (line_open_) fmt::print(stderr, "\n");
        const double spent = std::max(seconds_since(start_), 1e-9);
        fmt::print(
            "{}: {} samples a pixel, noise {:.3f} %, {:.1f} s, {:.2f} million rays and {:.2f} million events a "
            "second{}\n",
            options_.output().string(), film_->samples(), 100.0 * film_->noise(), spent,
            static_cast<double>(tracer_->rays()) / spent / 1e6, static_cast<double>(tracer_->events()) / spent / 1e6,
            interrupted ? " (interrupted: --resume goes on)" : "");
    }

    void save() {
        const fs::path folder = options_.output().parent_path();
        if (!folder.empty()) fs::create_directories(folder);
        film_->save(options_.output());
        saved_ = Clock::now();
    }

    /// A full disk does not end a long trace: what was saved last stays, and saving is tried again.
    void checkpoint() {
        try {
            save();
        } catch (const Error& error) {
            log::warning("{}; tracing goes on", error.what());
            saved_ = Clock::now();
        }
    }

    void save_display() const {
        Image picture = film_->radiance();
        const Camera& camera = engine_.scene().camera;
        const float exposure = camera.exposure.value_or(1.0f / (1.2f * std::exp2(camera.ev100)));
        for (float& value : picture.floats()) value *= exposure;
        engine_.color().apply_display(picture.floats(), engine_.options().display, engine_.options().view);
        save_png(fs::path(options_.output()).replace_extension(".png"), to_u8(picture));
    }

    const TraceOptions& options_;
    mutable Engine engine_;
    std::unique_ptr<Tracer> tracer_;
    std::optional<Film> film_;
    Share share_;
    int64_t resumed_ = 0;
    Clock::time_point start_ = Clock::now(), shown_ = start_, saved_ = start_;
    bool line_open_ = false;
};

/// A film that outgrows the user's limit of file sizes is an error like a full disk, not the end of the process.
void survive_file_size_limit() {
    std::signal(SIGXFSZ, SIG_IGN);
}

int trace(const TraceOptions& options) {
    survive_file_size_limit();
    std::optional<ThreadLimit> limit;
    if (options.threads > 0) limit.emplace(static_cast<size_t>(options.threads));
    TraceRun run(options);
    const auto on_signal = [](int) { interrupted = true; };
    std::signal(SIGINT, on_signal);
    std::signal(SIGTERM, on_signal);
    return run.run();
}

int merge(const std::vector<std::string>& files, const std::string& out) {
    survive_file_size_limit();
    std::optional<Film> sum;
    int64_t bad = 0;
    for (const std::string& file : files) {
        try {
            Film film = Film::load(file);
            if (sum)
                sum->merge(film);
            else
                sum = std::move(film);
        } catch (Error& error) {
            fmt::print(stderr, "tyndall: {}\n", error.within("merging " + file).what());
            ++bad;
        }
    }
    if (!sum) throw Error("none of the films could be read: nothing was written");
    sum->save(out);
    fmt::print("{}: {} samples a pixel, noise {:.3f} %{}\n", out, sum->samples(), 100.0 * sum->noise(),
               bad > 0 ? fmt::format("; {} of {} films were left out", bad, files.size()) : "");
    return bad > 0 ? 1 : 0;
}

void add_stops(CLI::App& sub, TraceOptions& options) {
    sub.add_option("--spp", options.spp, "Samples a pixel, rounded up to whole batches")
        ->check(CLI::Range(int64_t{1}, int64_t{1} << 32));
    sub.add_option("--time", options.time_s, "Seconds to trace")->check(CLI::PositiveNumber);
    sub.add_option("--noise", options.noise, "Stop at this noise: root mean square error over the mean, such as 0.01")
        ->check(CLI::PositiveNumber);
    sub.add_option("--batch", options.batch, "Samples that share one low-discrepancy sequence: a power of two")
        ->check(CLI::Range(1, 65536));
    sub.add_option("--threads", options.threads, "Threads; all cores otherwise")->check(CLI::Range(1, 1024));
    sub.add_option("--seed", options.seed, "Another seed gives an independent picture");
    sub.add_option("--out", options.out, "The film, an EXR; otherwise the scene's name");
    sub.add_flag("--png", options.png, "Also write the picture through the display transform");
    sub.add_flag("--resume", options.resume, "Go on with the film where it stopped");
    sub.add_option("--shard", options.shard, "Trace part I of N, to be added by tyndall merge")->type_name("I/N");
    sub.add_option("--checkpoint", options.checkpoint_s, "Seconds between saves")
        ->capture_default_str()
        ->check(CLI::NonNegativeNumber);
}

void add_parts(CLI::App& sub, TraceOptions& options) {
    sub.add_flag("--single-scattering", options.single,
                 "Light scattered once at most, by surfaces or media: what the real-time passes approximate");
    sub.add_option("--orders", options.orders, "Only light scattered this many times")->type_name("A..B");
    sub.add_flag("--components", options.components, "Film emission, surface, medium and multiple apart, too");
    sub.add_flag("--no-surfaces", options.no_surfaces, "Surfaces are black");
    sub.add_flag("--no-media", options.no_media, "Media absorb and emit, but do not scatter");
    sub.add_option("--clamp", options.clamp, "Clamp samples at this many times white: less noise, some light is lost")
        ->check(CLI::NonNegativeNumber);
}

}  // namespace

void add_trace(CLI::App& app, Command& command) {
    auto options = std::make_shared<TraceOptions>();
    CLI::App* sub = app.add_subcommand("trace", "Path-trace a scene: the truth that techniques are held against");
    sub->add_option("scene", options->file, "Scene file")->required();
    sub->add_option("--size", options->size, "WIDTHxHEIGHT")->capture_default_str();
    add_stops(*sub, *options);
    add_parts(*sub, *options);
    options->scene.add_scene_to(*sub);
    sub->callback([options, &command] {
        if (options->spp == 0 && options->time_s == 0.0 && options->noise == 0.0) options->spp = 64;
        command = [options] { return trace(*options); };
    });
}

void add_merge(CLI::App& app, Command& command) {
    struct Options {
        std::vector<std::string> files;
        std::string out;
    };
    auto options = std::make_shared<Options>();
    CLI::App* sub = app.add_subcommand("merge", "Add the shards of a trace");
    sub->add_option("films", options->files, "Films of tyndall trace --shard")->required();
    sub->add_option("--out", options->out, "The sum")->required();
    sub->callback([options, &command] { command = [options] { return merge(options->files, options->out); }; });
}

}  // namespace tyndall
