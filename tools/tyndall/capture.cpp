#include "app/capture.h"

#include <fmt/format.h>

#include <cstdio>

#include "capture_report.h"
#include "commands.h"
#include "core/error.h"
#include "core/paths.h"
#include "image/image_io.h"
#include "retrace.h"

namespace tyndall {
namespace fs = std::filesystem;
namespace {

struct CaptureOptions {
    SceneOptions scene;
    std::vector<std::string> files;
    std::string out = "out";
    std::string size, retrace, report, history;
    int frames = 0;
    int supersample = 1;
    bool all_cameras = false, png = false, exr = false;

    /// Both kinds unless one was asked for.
    [[nodiscard]] PictureFiles pictures() const { return {png || !exr, exr || !png}; }
};

/// A file name part without separators and spaces.
std::string plain(std::string name) {
    for (char& c : name)
        if (c == '/' || c == ' ' || c == '\\') c = '_';
    return name;
}

/// Takes, writes and judges the pictures of the named files.
class Run {
 public:
    Run(const CaptureOptions& options)
        : options_(options), context_(platform::create_headless_context()), engine_(true, options.scene.ocio) {}

    int all() {
        for (const std::string& file : options_.files) {
            if (is_capture(paths::read_file(file)))
                capture(load_capture(file));
            else
                scene(file);
        }
        if (!options_.report.empty()) write_report();
        if (failed_ > 0)
            fmt::print("{} of {} expectations failed\n", failed_, judged_);
        else if (judged_ > 0)
            fmt::print("{} expectations held\n", judged_ - skipped_);
        return failed_ > 0 ? 1 : 0;
    }

 private:
    void scene(const fs::path& file) {
        const Assignments changes = options_.scene.changes();
        engine_.load_scene(file, changes);
        std::vector<std::string> cameras{options_.scene.camera};
        if (options_.all_cameras) cameras = engine_.cameras();
        plan(cameras.size());
        for (const std::string& camera : cameras) {
            Shot shot = shot_of(camera, {1280, 720}, 1);
            shot.target = options_.scene.view;
            const std::string name = camera.empty() ? file.stem().string() : file.stem().string() + "-" + plain(camera);
            shoot(shot, changes, fs::path(options_.out) / name);
        }
    }

    void capture(const CaptureFile& file) {
        std::vector<std::string> cameras = file.cameras;
        if (!options_.scene.camera.empty()) cameras = {options_.scene.camera};
        if (cameras.empty()) cameras = {""};
        plan(cameras.size() * file.variants.size());
        for (const std::string& camera : cameras) {
            const fs::path stem =
                fs::path(options_.out) / (file.file.stem().string() + (camera.empty() ? "" : "-" + plain(camera)));
            std::map<std::string, CapturedPicture> pictures;
            for (const CaptureVariant& variant : file.variants)
                pictures[variant.name] = variant_picture(file, variant, camera, stem);
            std::vector<Verdict> verdicts = judge(file, pictures, camera);
            print(verdicts, stem);
            if (!options_.report.empty()) report_.add(file, stem.filename().string(), verdicts);
        }
    }

    /// So many pictures follow.
    void plan(size_t pictures) {
        planned_ = pictures;
        taken_ = 0;
    }

    CapturedPicture variant_picture(const CaptureFile& file, const CaptureVariant& variant, const std::string& camera,
                                    const fs::path& stem) {
        Assignments changes;
        for (const std::string& text : variant.set) changes.push_back(split_assignment(text));
        for (const auto& change : options_.scene.changes()) changes.push_back(change);
        engine_.load_scene(file.file.parent_path() / file.scene, changes);
        Shot shot = shot_of(variant.camera.empty() ? camera : variant.camera, glm::ivec2(file.size),
                            variant.frames > 0 ? variant.frames : file.frames);
        shot.step_s = static_cast<double>(file.step_s);
        shot.target = variant.target;
        return shoot(shot, changes, stem.string() + "-" + plain(variant.name));
    }

    [[nodiscard]] Shot shot_of(const std::string& camera, glm::ivec2 size, int frames) const {
        Shot shot;
        shot.camera = camera;
        shot.size = options_.size.empty() ? size : parse_size(options_.size);
        shot.frames = options_.frames > 0 ? options_.frames : frames;
        shot.supersample = options_.supersample;
        return shot;
    }

    CapturedPicture shoot(const Shot& shot, const Assignments& changes, const fs::path& stem) {
        CapturedPicture picture = take(engine_, shot);
        if (!engine_.problems().empty() || !engine_.unmade().empty())  // which were logged
            throw Error(
                Diagnostic{{engine_.scene_path().string()}, "no picture is written, because of the errors above"});
        const PictureFiles kinds = options_.pictures();
        write(engine_, context_->gl_info(), shot, changes, picture, stem, kinds);
        fmt::print("[{}/{}] wrote {}.{}\n", ++taken_, planned_, stem.string(),
                   kinds.png && kinds.exr ? "{png,exr,json}"
                   : kinds.png            ? "{png,json}"
                                          : "{exr,json}");
        std::fflush(stdout);
        return picture;
    }

    void write_report() {
        const platform::GlInfo& gl = context_->gl_info();
        report_.write(options_.report, options_.history, {{"GL", gl.renderer + ", " + gl.version}});
        fmt::print("report: {}\n", (fs::path(options_.report) / "index.html").string());
    }

    void print(const std::vector<Verdict>& verdicts, const fs::path& stem) {
        for (size_t i = 0; i < verdicts.size(); ++i) {
            const Verdict& verdict = verdicts[i];
            const char* mark = verdict.outcome == Verdict::Outcome::held     ? "ok     "
                               : verdict.outcome == Verdict::Outcome::failed ? "FAILED "
                                                                             : "skipped";
            fmt::print("  {} {}\n", mark, verdict.text);
            ++judged_;
            if (verdict.outcome == Verdict::Outcome::skipped) ++skipped_;
            if (verdict.outcome != Verdict::Outcome::failed) continue;
            ++failed_;
            fmt::print("          GL: {}, {}\n", context_->gl_info().renderer, context_->gl_info().version);
            if (verdict.heat_map.empty()) continue;
            const fs::path map = stem.string() + "-difference" + std::to_string(i) + ".png";
            save_png(map, verdict.heat_map);
            fmt::print("          where it differs: {}\n", map.string());
        }
    }

    const CaptureOptions& options_;
    std::unique_ptr<platform::Context> context_;  // outlives the engine
    Engine engine_;
    size_t planned_ = 0, taken_ = 0;  ///< pictures of the file at hand
    CaptureReport report_;
    int judged_ = 0, failed_ = 0, skipped_ = 0;
};

/// Makes the references of capture files again.
int retrace_all(const CaptureOptions& options) {
    for (const std::string& file : options.files) {
        if (!is_capture(paths::read_file(file)))
            throw Error(Diagnostic{{file}, "is no capture file, and has no references to trace"});
        retrace(load_capture(file), options.retrace, options.scene.ocio);
    }
    return 0;
}

}  // namespace

void add_capture(CLI::App& app, Command& command) {
    auto options = std::make_shared<CaptureOptions>();
    CLI::App* sub =
        app.add_subcommand("capture", "Write pictures of scenes, or run capture files and judge what they expect");
    sub->add_option("files", options->files, "Scene files, or capture files (docs/captures.md)")->required();
    sub->add_option("--out", options->out, "Folder for the pictures")->capture_default_str();
    sub->add_option("--size", options->size, "WIDTHxHEIGHT; otherwise 1280x720 or the capture's own");
    sub->add_option("--frames", options->frames, "Frames at a fixed clock; the last one is written")
        ->check(CLI::Range(1, 100000));
    sub->add_option("--supersample", options->supersample, "Render this many times larger and filter down")
        ->check(CLI::Range(1, 8));
    sub->add_flag("--all-cameras", options->all_cameras, "A picture from each camera of the scene");
    sub->add_flag("--png", options->png, "Only the display picture (and its .json)");
    sub->add_flag("--exr", options->exr, "Only the scene-linear picture (and its .json)");
    sub->add_option("--report", options->report, "Folder for an HTML report of what was judged");
    sub->add_option("--history", options->history, "File of the report's past runs; otherwise history.jsonl in it");
    CLI::Option* retrace = sub->add_flag("--retrace{changed}", options->retrace,
                                         "Only trace the references of capture files again: those that changed, or "
                                         "--retrace=all, or --retrace=NAME");
    options->scene.add_to(*sub);
    for (const char* other : {"--set", "--camera", "--path", "--view", "--size", "--frames", "--supersample",
                              "--all-cameras", "--png", "--exr", "--report"})
        retrace->excludes(sub->get_option(other));
    sub->footer(
        "Exit code 1: an expectation failed, or something of a scene could not be read.\n\n"
        "  tyndall capture assets/chapel/chapel.json --all-cameras --size 1920x1080\n"
        "  tyndall capture assets/scenes/still_life.json --path light_pre_pass --view light_diffuse\n"
        "  tyndall capture scene.json --set /entities/Sun/directional_light/illuminance_lux=20000\n"
        "  tyndall capture tests/captures/*.json --report out/report\n"
        "  tyndall capture --retrace modules/participating_media/captures/*.json\n");
    sub->callback([options, &command] {
        command = [options] { return options->retrace.empty() ? Run(*options).all() : retrace_all(*options); };
    });
}

}  // namespace tyndall
