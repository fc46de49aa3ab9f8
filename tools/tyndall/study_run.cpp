#include "study_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <thread>

#include "app/capture.h"
#include "app/reference_recipe.h"
#include "core/build_info.h"
#include "core/error.h"
#include "core/log.h"
#include "core/paths.h"
#include "frame_timing.h"
#include "image/comparison.h"
#include "measure/noise_floor.h"
#include "study_refusal.h"
#include "trace_recipe.h"

namespace tyndall {
namespace fs = std::filesystem;
namespace {

using measure::Row;
using measure::Run;
using measure::StudyScene;

/// The scene's pictures with these changes: at the plain size and, where it is another, supersampled.
struct Pictures {
    Image frame, filtered;
};

Pictures pictures_of(Engine& engine, const fs::path& file, const StudyScene& scene, const Assignments& changes) {
    engine.load_scene(file, changes);
    Shot shot{scene.camera, glm::ivec2(scene.size), scene.frames};
    Pictures pictures;
    pictures.frame = take(engine, shot).radiance;
    shot.supersample = scene.supersample;
    pictures.filtered = scene.supersample > 1 ? take(engine, shot).radiance : pictures.frame;
    if (const std::string problems = engine.problems() + engine.unmade(); !problems.empty()) throw Error(problems);
    return pictures;
}

void subtract(Image& from, const Image& what) {
    for (size_t i = 0; i < from.value_count(); ++i) from.floats()[i] -= what.floats()[i];
}

/// Every metric that has a better and a worse.
std::map<std::string, double> judged(const Comparison& comparison, const std::string& prefix) {
    std::map<std::string, double> metrics;
    for (const Metric& metric : metrics_with_limits())
        if (const auto found = comparison.metrics.find(metric.name); found != comparison.metrics.end())
            metrics[prefix + metric.name] = found->second;
    return metrics;
}

/// What an error says, without the line breaks at its end.
std::string line_of(const Error& error) {
    std::string text = error.what();
    while (text.ends_with('\n')) text.pop_back();
    return text;
}

std::string machine() {
    std::string model = "unknown processor";
    try {
        const std::string text = paths::read_file("/proc/cpuinfo");
        const size_t at = text.find("model name"), colon = text.find(": ", at);
        if (at != std::string::npos && colon != std::string::npos)
            model = text.substr(colon + 2, text.find('\n', colon) - colon - 2);
    } catch (const Error&) {  // no such file outside Linux
    }
    return fmt::format("{}, {} cores", model, std::thread::hardware_concurrency());
}

}  // namespace

StudyRun::StudyRun(const measure::Study& study, const StudyOptions& options)
    : study_(study),
      options_(options),
      runs_(measure::runs_of(study, options.only)),
      films_(options.cache),
      rows_(options.cache / (study.name() + ".unfinished")),
      context_(platform::create_headless_context()) {}

StudyRun::~StudyRun() = default;

bool StudyRun::all() {
    for (const StudyScene& scene : study_.scenes) {
        const bool wanted = std::ranges::any_of(runs_, [&](const Run& run) { return run.scene == &scene; });
        if (wanted && !measure_scene(scene)) return false;
    }
    rows_.forget();
    return true;
}

bool StudyRun::measure_scene(const StudyScene& scene) {
    MeasuredScene& measured_scene = scenes_.emplace_back();
    measure::SceneResults& results = measured_scene.results;
    results.name = scene.name;
    results.doc = scene.doc;
    results.size = glm::ivec2(scene.size);
    results.supersample = study_.compare ? scene.supersample : 1;
    Truth& truth = measured_scene.truth;
    std::string problem;
    if (options_.earlier)
        options_.earlier->fill(results);
    else if (study_.compare && !find_truth(scene, measured_scene, problem))
        return false;
    auto engine = std::make_unique<Engine>(true);  // a fresh one: memory is then this scene's alone
    for (const Run& run : runs_) {
        if (run.scene != &scene) continue;
        if (options_.cancelled && options_.cancelled()) return false;
        const std::string key = key_of(run, truth);
        std::optional<MeasuredRow> kept;
        if (problem.empty() && !options_.restart) kept = rows_.find(key);
        MeasuredRow row;
        row.row.problem = problem;
        if (kept)
            row = std::move(*kept);
        else if (problem.empty()) {
            if (!run.technique->refused_if.empty()) engine = std::make_unique<Engine>(true);  // which says it again
            row = measured(run, *engine, truth);
        }
        row.row.scene = scene.name;
        row.row.technique = run.technique->name;
        row.row.label = run.label();
        row.row.parameters = run.parameters;
        row.row.baseline = run.baseline;
        if (!kept && row.row.problem.empty()) keep(key, row);
        tell(row.row, kept.has_value());
        results.rows.push_back(std::move(row.row));
        measured_scene.pictures.push_back(std::move(row.picture));
    }
    return true;
}

bool StudyRun::find_truth(const StudyScene& scene, MeasuredScene& into, std::string& problem) {
    Truth& truth = into.truth;
    try {
        truth = truth_of(study_, scene, films_, watch(scene.name));
        if (!truth.complete) return false;
        into.results.noise_floor = measure::noise_floor(truth.picture);
        if (!truth.problem.empty()) log::warning("{}", truth.problem);
        fmt::print("{}: reference {}\n", scene.name, truth.about);
    } catch (const Error& error) {
        problem = "no reference: " + line_of(error);
        fmt::print("{}: {}\n", scene.name, problem);
    }
    into.results.reference = truth.about;
    return true;
}

/// A full disk does not end a study: it cannot be gone on with, that is all.
void StudyRun::keep(const std::string& key, const MeasuredRow& row) {
    try {
        rows_.keep(key, row);
    } catch (const std::exception& error) {
        if (!warned_) log::warning("{}; rows are measured, but not kept for a run that goes on", error.what());
        warned_ = true;
    }
}

MeasuredRow StudyRun::measured(const Run& run, Engine& engine, const Truth& truth) const {
    MeasuredRow row;
    try {
        const Refusal refusal(run.technique->refused_if);
        time(run, engine, row.row);
        if (!refusal.reason().empty()) {
            row = {};
            row.row.refused = true;
            row.row.problem = refusal.reason();
            return row;
        }
        if (run.baseline || !study_.compare) return row;
        if (options_.earlier)
            options_.earlier->fill(run.scene->name, run.label(), row.row);
        else
            compare(run, engine, truth, row);
    } catch (const Error& error) {
        row = {};
        row.row.problem = line_of(error);
    }
    return row;
}

void StudyRun::time(const Run& run, Engine& engine, Row& row) const {
    engine.load_scene(study_.file.parent_path() / run.scene->scene, assignments(run.set));
    engine.select_camera(run.scene->camera);
    if (engine.extract().cameras.empty()) throw Error(run.scene->scene + ": the scene has no camera");
    const FrameTime time = time_frames(engine, {glm::ivec2(run.size), study_.bench.frames, study_.bench.warmup});
    row.ms = time.whole;
    row.least_ms = time.least;
    row.processor_ms = time.processor;
    row.target_bytes = static_cast<double>(engine.renderer().statistics().target_bytes);
    row.texture_bytes = static_cast<double>(gpu::alive().texture_bytes);
    if (const std::string problems = engine.problems() + engine.unmade(); !problems.empty()) throw Error(problems);
}

void StudyRun::compare(const Run& run, Engine& engine, const Truth& truth, MeasuredRow& row) const {
    const StudyScene& scene = *run.scene;
    const fs::path file = study_.file.parent_path() / scene.scene;
    Assignments changes = assignments(run.set);
    Pictures pictures = pictures_of(engine, file, scene, changes);
    if (!scene.subtract.empty()) {
        for (const auto& change : assignments(scene.subtract)) changes.push_back(change);
        const Pictures rest = pictures_of(engine, file, scene, changes);
        subtract(pictures.frame, rest.frame);
        subtract(pictures.filtered, rest.filtered);
    }
    ComparisonOptions how;
    how.hdr_flip = std::ranges::any_of(study_.plots, [](const auto& plot) { return plot.ends_with("hdr_flip"); });
    const Comparison found = compare_pictures(truth.picture, {pictures.filtered, {}}, how);
    row.row.metrics = found.metrics;
    row.row.notes = found.notes;
    if (!found.finite) throw Error(found.notes.empty() ? "the picture holds NaN or Inf" : found.notes.front());
    row.row.metrics.merge(judged(compare_pictures({truth.picture.radiance, {}}, {pictures.frame, {}}, how), "frame_"));
    row.picture = std::move(pictures.filtered);
}

std::string StudyRun::key_of(const Run& run, const Truth& truth) const {
    const StudyScene& scene = *run.scene;
    const fs::path file = study_.file.parent_path() / scene.scene;
    const nlohmann::json all = {build_info().revision,
                                context_->gl_info().renderer,
                                fs::exists(file) ? content_hash(paths::read_file(file)) : "",
                                run.set,
                                scene.subtract,
                                scene.camera,
                                {run.size.x, run.size.y, static_cast<float>(scene.supersample)},
                                {scene.frames, study_.bench.frames, study_.bench.warmup},
                                study_.plots,
                                truth.identity + (options_.earlier ? "timed alone" : ""),
                                run.baseline};
    return content_hash(all.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace));
}

void StudyRun::tell(const Row& row, bool kept) {
    const bool told = row.problem.starts_with("no reference: ");  // of the whole scene
    std::string what = row.problem.empty() ? fmt::format("{:.1f} ms", row.ms)
                       : told              ? "FAILED"
                                           : (row.refused ? "cannot: " : "FAILED: ") + row.problem;
    for (const std::string& metric : study_.plots)
        if (const auto found = row.metrics.find(metric); found != row.metrics.end())
            what += fmt::format(", {} {:.3g}", metric, found->second);
    if (!row.problem.empty() && !row.refused) ++failed_;
    fmt::print("[{}/{}] {}: {}: {}{}\n", ++done_, runs_.size(), row.scene, row.label, what,
               kept ? " (measured before the interruption)" : "");
    std::fflush(stdout);
}

TraceWatch StudyRun::watch(const std::string& scene) const {
    using Clock = std::chrono::steady_clock;
    const auto shown = std::make_shared<Clock::time_point>(Clock::now());
    return {
        options_.cancelled, [scene, shown](const reference::Film& film, int64_t wanted) {
            if (Clock::now() - *shown < std::chrono::seconds(5)) return;
            *shown = Clock::now();
            const std::string noise = film.batches() > 1 ? fmt::format(", noise {:.2f} %", 100.0 * film.noise()) : "";
            fmt::print(stderr, "{}: tracing the reference, {} of {} samples{}\n", scene, film.samples(), wanted, noise);
        }};
}

measure::Results StudyRun::results() const {
    measure::Results all;
    all.study = study_.file.filename().string();
    all.title = study_.title.empty() ? study_.name() : study_.title;
    all.doc = study_.doc;
    all.clock = study_.clock;
    all.baseline = study_.baseline;
    all.plots = study_.plots;
    all.against = study_.against;
    all.compare = study_.compare;
    const platform::GlInfo& gl = context_->gl_info();
    all.facts = {{"GL renderer", gl.renderer},
                 {"GL version", gl.version},
                 {"machine", machine()},
                 {"timing", fmt::format("median of {} frames after {}, by {}", study_.bench.frames, study_.bench.warmup,
                                        timing_method())},
                 {"program", build_info().version + " " + build_info().revision}};
    if (options_.earlier) all.facts.emplace_back("errors", "measured by program " + options_.earlier->program());
    for (const MeasuredScene& scene : scenes_) all.scenes.push_back(scene.results);
    measure::conclude(all);
    return all;
}

}  // namespace tyndall
