// measure: error against time of techniques and their parameters.

#include <fmt/format.h>

#include <atomic>
#include <csignal>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "commands.h"
#include "core/error.h"
#include "core/paths.h"
#include "report/entry.h"
#include "study_run.h"

namespace tyndall {
namespace fs = std::filesystem;
namespace {

std::atomic<bool> interrupted{false};

struct MeasureOptions {
    std::string study, cache, errors, json, markdown, svg, report;
    std::vector<std::string> only;
    bool restart = false, all_pictures = false;
};

std::string section_html(const measure::Results& results, const measure::SceneResults& scene) {
    std::string html;
    const std::string reference = scene.reference.empty() ? "" : "Reference: " + scene.reference + ".";
    for (const std::string& text : {scene.doc, reference})
        if (!text.empty()) html += "<p>" + measure::escaped(text) + "</p>";
    for (const measure::Plot& plot : measure::plots_of(results, scene))
        html += "<figure>" + measure::svg_of(plot) + "</figure>";
    html += measure::html_of(measure::table_of(results, scene));
    if (!results.compare) return html;
    return html +
           "<p class=\"small\">● is on the Pareto front; ≈ is no more than twice the noise of the reference.</p>";
}

report::Entry entry_of(const measure::Row& row, const MeasuredScene& scene, size_t index) {
    report::Entry entry;
    entry.name = row.scene + ": " + row.label;
    entry.scene = row.scene;
    entry.reason = fmt::format("{:.1f} ms a frame", row.ms);
    entry.reference_name = scene.truth.about;
    entry.test_name = row.label;
    entry.reference = scene.truth.picture.radiance;
    entry.test = scene.pictures[index];
    report::compare(entry, {}, scene.truth.picture.variance);
    return entry;
}

/// Writes what was asked for.
class Output {
 public:
    Output(const MeasureOptions& options, const StudyRun& run)
        : options_(options), run_(run), results_(run.results()) {}

    void all() const {
        if (!options_.json.empty()) put(options_.json, measure::to_json(results_).dump(2, ' ', false, kReplace) + "\n");
        if (!options_.markdown.empty()) put(options_.markdown, measure::markdown_of(results_));
        if (!options_.svg.empty()) plots();
        if (!options_.report.empty()) report();
    }

 private:
    static constexpr auto kReplace = nlohmann::json::error_handler_t::replace;

    static void put(const fs::path& file, const std::string& text) {
        if (file == "-") {
            fmt::print("{}", text);
            return;
        }
        if (file.has_parent_path()) fs::create_directories(file.parent_path());
        paths::write_file_atomically(file, text);
    }

    void plots() const {
        for (const measure::SceneResults& scene : results_.scenes)
            for (const measure::Plot& plot : measure::plots_of(results_, scene))
                put(fs::path(options_.svg) / (plot.id + ".svg"), measure::svg_of(plot));
    }

    void report() const {
        report::Report report;
        report.title = results_.title;
        report.introduction = results_.doc;
        report.facts = results_.facts;
        for (size_t s = 0; s < results_.scenes.size(); ++s) {
            const measure::SceneResults& scene = results_.scenes[s];
            report.sections.push_back({scene.name, section_html(results_, scene)});
            for (size_t i = 0; i < scene.rows.size(); ++i)
                if (!run_.scenes()[s].pictures[i].empty() && (scene.rows[i].on_front || options_.all_pictures))
                    report.entries.push_back(entry_of(scene.rows[i], run_.scenes()[s], i));
        }
        report::write_report(options_.report, report);
        fmt::print("report: {}\n", (fs::path(options_.report) / "index.html").string());
    }

    const MeasureOptions& options_;
    const StudyRun& run_;
    measure::Results results_;
};

int measured(const MeasureOptions& options) {
    const measure::Study study = measure::load_study(options.study);
    StudyOptions how;
    how.cache = options.cache.empty() ? paths::root() / "build" / "references" : fs::path(options.cache);
    how.only = options.only;
    how.restart = options.restart;
    if (!options.errors.empty()) how.earlier = std::make_shared<EarlierErrors>(options.errors);
    how.cancelled = [] { return interrupted.load(); };
    const auto on_signal = [](int) { interrupted = true; };
    std::signal(SIGINT, on_signal);
    std::signal(SIGTERM, on_signal);
    StudyRun run(study, how);
    if (!run.all()) {
        fmt::print(stderr, "tyndall: interrupted; the same command goes on where it stopped\n");
        return 130;
    }
    Output(options, run).all();
    if (run.failed() > 0) fmt::print("{} runs failed\n", run.failed());
    return run.failed() > 0 ? 1 : 0;
}

int run(const MeasureOptions& options) {
    try {
        return measured(options);
    } catch (const Error& error) {
        std::fprintf(stderr, "tyndall: %s\n", error.what());
    } catch (const fs::filesystem_error& error) {
        std::fprintf(stderr, "tyndall: %s\n", error.what());
    }
    return 2;
}

}  // namespace

void add_measure(CLI::App& app, Command& command) {
    auto options = std::make_shared<MeasureOptions>();
    CLI::App* sub = app.add_subcommand("measure", "Error against time of techniques and their parameters");
    sub->add_option("study", options->study, "Study file (docs/measure.md)")->required();
    sub->add_option("--only", options->only, "A scene or a technique of the study; may be given often")
        ->type_name("NAME")
        ->allow_extra_args(false);
    sub->add_option("--cache", options->cache, "Folder of traced references; otherwise build/references");
    sub->add_flag("--restart", options->restart, "Measure again what an interrupted run had finished");
    sub->add_option("--errors", options->errors,
                    "Time alone; the errors are those of an earlier run, which wrote this file by --json")
        ->type_name("FILE");
    sub->add_option("--json", options->json, "File for the numbers; - prints them");
    sub->add_option("--markdown", options->markdown, "File for a table; - prints it");
    sub->add_option("--svg", options->svg, "Folder for the plots");
    sub->add_option("--report", options->report, "Folder for an HTML report");
    sub->add_flag("--all-pictures", options->all_pictures, "Report every picture, not those of the Pareto front alone");
    sub->footer(
        "Exit code 1: a run failed, and its row says why. 2: the study cannot be read, or something cannot be "
        "written.\n"
        "Ctrl-C keeps what is done: the same command goes on.\n\n"
        "  tyndall measure modules/participating_media/studies/march.json --report out/march\n"
        "  tyndall measure study.json --only fog --json numbers.json --markdown - --svg docs/images\n");
    sub->callback([options, &command] { command = [options] { return run(*options); }; });
}

}  // namespace tyndall
