#include "app/capture_file.h"

#include <algorithm>

#include "core/error.h"
#include "core/paths.h"
#include "scene/scene_file.h"

namespace tyndall {

void describe(StructBuilder<CaptureVariant>& d) {
    d.doc("The scene with a few values changed; gives one picture per camera.");
    d.field("name", &CaptureVariant::name, "Names the pictures and is what expectations refer to.");
    d.field("set", &CaptureVariant::set, "Changes to the scene file, as \"/json/pointer=value\".");
    d.field("camera", &CaptureVariant::camera, "Entity with a camera; the capture's when empty.");
    d.field("target", &CaptureVariant::target, "A frame-graph target to capture instead of the radiance.");
    d.field("frames", &CaptureVariant::frames, "Frames to run before the picture is taken; 0 = the capture's.")
        .range(0, 100000);
}

void describe(StructBuilder<Expectation>& d) {
    d.doc("One thing that must hold of a variant's scene-linear picture. NaN and Inf always fail.");
    d.field("of", &Expectation::of, "The variant that is judged.");
    d.field("equals", &Expectation::equals, "Another variant that it is held against.");
    d.field("reference", &Expectation::reference,
            "A scene-linear image that it is held against: beside the capture, or references:NAME.");
    d.field("display", &Expectation::display, "Judges the display pictures' values, 0 to 1, in place of the radiance.");
    d.field("scale", &Expectation::scale, "The other picture is multiplied by this first.").range(0, 1e6);
    d.field("box_filter", &Expectation::box_filter, "The judged picture is shrunk by this factor first.").range(1, 64);
    d.field("max_relmse", &Expectation::max_relmse, "Largest mean((x-r)^2 / (r^2 + (0.1 mean r)^2)).").range(-1, 1e6);
    d.field("max_mean_error", &Expectation::max_mean_error, "Largest |mean(x)/mean(r) - 1|.").range(-1, 1e6);
    d.field("max_flip", &Expectation::max_flip, "Largest mean FLIP of the display pictures.").range(-1, 1);
    d.field("max_difference", &Expectation::max_difference,
            "Largest absolute difference of a channel; 0 = the same bits.")
        .range(-1, 1e9);
    d.field("region", &Expectation::region, "Left, top, width, height as fractions of the picture.").range(0, 1);
    d.field("mean_between", &Expectation::mean_between, "Bounds on the region's mean luminance.")
        .unit("cd/m2")
        .range(-1, 1e9);
    d.field("reason", &Expectation::reason, "Why this limit.");
}

void describe(StructBuilder<CaptureFile>& d) {
    d.doc("Pictures of a scene at a fixed clock, one thing changed at a time, and what must hold of them.");
    d.field("tyndall_capture", &CaptureFile::tyndall_capture, "Version of the format.").range(1, 1);
    d.field("doc", &CaptureFile::doc, "What this capture is for.");
    d.field("scene", &CaptureFile::scene, "Scene file, relative to this one.");
    d.field("cameras", &CaptureFile::cameras, "Entities with a camera; empty = the scene's own choice.");
    d.field("size", &CaptureFile::size, "Width and height.").unit("px").range(1, 16384);
    d.field("frames", &CaptureFile::frames, "Frames to run before the picture is taken.").range(1, 100000);
    d.field("step_s", &CaptureFile::step_s, "The clock's step from frame to frame.").unit("s").range(0, 10);
    d.field("variants", &CaptureFile::variants, "What is changed; without any, the scene as it is.");
    d.field("expect", &CaptureFile::expect, "What must hold.");
}

bool is_capture(const std::string& text) {
    return text.find("\"tyndall_capture\"") != std::string::npos;
}

namespace {

void check_names(const CaptureFile& capture, std::vector<Diagnostic>& problems) {
    std::vector<std::string> names;
    for (const CaptureVariant& variant : capture.variants) {
        if (std::find(names.begin(), names.end(), variant.name) != names.end())
            problems.push_back({{}, "two variants are named '" + variant.name + "'"});
        names.push_back(variant.name);
    }
    for (size_t i = 0; i < capture.expect.size(); ++i)
        for (const std::string& name : {capture.expect[i].of, capture.expect[i].equals})
            if (!name.empty() && std::find(names.begin(), names.end(), name) == names.end())
                problems.push_back({{{}, 0, 0, "/expect/" + std::to_string(i)},
                                    "unknown variant '" + name + "'",
                                    "a name from /variants",
                                    nearest_name(name, names)});
}

}  // namespace

CaptureFile load_capture(const std::filesystem::path& file) {
    CaptureFile capture;
    std::vector<Diagnostic> problems;
    const auto type = describe_struct<CaptureFile>("capture");
    const std::string unknown = component_from_json(*type, &capture, paths::read_file(file), problems);
    if (unknown.size() > 2) problems.push_back({{}, "unknown fields " + unknown, "the fields of docs/captures.md"});
    if (capture.variants.empty()) capture.variants.emplace_back();
    check_names(capture, problems);
    if (capture.scene.empty() && problems.empty()) problems.push_back({{{}, 0, 0, "/scene"}, "no scene is named"});
    for (Diagnostic& problem : problems) problem.where.file = file.string();
    if (!problems.empty()) throw Error(std::move(problems));
    capture.file = file;
    return capture;
}

}  // namespace tyndall
