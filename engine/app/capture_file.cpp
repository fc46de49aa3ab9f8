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

void describe(StructBuilder<TracedReference>& d) {
    d.doc("A picture of the reference path tracer, kept beside the capture file as NAME.exr.");
    d.field("name", &TracedReference::name, "Names the file, and is what expectations refer to.");
    d.field("variant", &TracedReference::variant, "The variant whose scene is traced; the first when empty.");
    d.field("set", &TracedReference::set, "Further changes to the scene file, after the variant's.");
    d.field("camera", &TracedReference::camera, "Entity with a camera; the variant's or the capture's when empty.");
    d.field("size", &TracedReference::size, "Width and height; the capture's when 0. It must divide that.")
        .unit("px")
        .range(0, 16384);
    d.field("samples", &TracedReference::samples, "Samples a pixel, at most.").range(2, 1 << 24);
    d.field("noise", &TracedReference::noise, "Stop at this noise, root mean square error over the mean; 0 = do not.")
        .range(0, 10);
    d.field("seed", &TracedReference::seed, "Another seed gives an independent picture.").range(0, 1 << 30);
    d.field("orders", &TracedReference::orders, "Fewest and most times that light was scattered; empty = any.");
    d.field("single_scattering", &TracedReference::single_scattering,
            "Light scattered once at most: what the real-time passes approximate.");
    d.field("no_surfaces", &TracedReference::no_surfaces, "Surfaces are black.");
    d.field("no_media", &TracedReference::no_media, "Media absorb and emit, but do not scatter.");
}

void describe(StructBuilder<Expectation>& d) {
    d.doc("One thing that must hold of a variant's scene-linear picture. NaN and Inf always fail.");
    d.field("of", &Expectation::of, "The variant that is judged.");
    d.field("equals", &Expectation::equals, "Another variant that it is held against.");
    d.field("reference", &Expectation::reference,
            "A scene-linear image that it is held against: beside the capture, or references:NAME.");
    d.field("traced", &Expectation::traced, "One of the capture's traced references that it is held against.");
    d.field("baseline", &Expectation::baseline, "The reference is an earlier picture, which no truth backs.");
    d.field("display", &Expectation::display, "Judges the display pictures' values, 0 to 1, in place of the radiance.");
    d.field("scale", &Expectation::scale, "The other picture is multiplied by this first.").range(0, 1e6);
    d.field("box_filter", &Expectation::box_filter, "The judged picture is shrunk by this factor first.").range(1, 64);
    d.field("max_relmse", &Expectation::max_relmse, "Largest mean((x-r)^2 / (r^2 + (0.1 mean r)^2)).").range(-1, 1e6);
    d.field("max_mean_error", &Expectation::max_mean_error, "Largest |mean(x)/mean(r) - 1|.").range(-1, 1e6);
    d.field("max_flip", &Expectation::max_flip, "Largest mean FLIP of the display pictures.").range(-1, 1);
    d.field("min_z_p", &Expectation::min_z_p,
            "Smallest p of the Z-test against a reference with a variance; the judged picture counts as exact.")
        .range(-1, 1);
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
    d.field("references", &CaptureFile::references, "Traced references, for expectations to name.");
    d.field("expect", &CaptureFile::expect, "What must hold.");
}

bool is_capture(const std::string& text) {
    return text.find("\"tyndall_capture\"") != std::string::npos;
}

namespace {

template <class Things>
std::vector<std::string> names_of(const Things& things) {
    std::vector<std::string> names;
    for (const auto& thing : things) names.push_back(thing.name);
    return names;
}

template <class Things>
const typename Things::value_type& called(const Things& things, const std::string& name, const CaptureFile& capture,
                                          const char* what) {
    for (const auto& thing : things)
        if (thing.name == name) return thing;
    throw Error(Diagnostic{{capture.file.string()},
                           std::string("unknown ") + what + " '" + name + "'",
                           std::string("a name from /") + what + "s",
                           nearest_name(name, names_of(things))});
}

/// Collects what is wrong with a capture file beyond the form of its fields.
class Check {
 public:
    Check(const CaptureFile& capture, std::vector<Diagnostic>& problems)
        : capture_(capture),
          problems_(problems),
          variants_(names_of(capture.variants)),
          references_(names_of(capture.references)) {}

    void all() {
        twice(variants_, "variants");
        twice(references_, "references");
        for (size_t i = 0; i < capture_.references.size(); ++i)
            reference(capture_.references[i], "/references/" + std::to_string(i));
        for (size_t i = 0; i < capture_.expect.size(); ++i)
            expectation(capture_.expect[i], "/expect/" + std::to_string(i));
    }

 private:
    void add(const std::string& pointer, std::string message, std::string expected = {}, std::string suggestion = {}) {
        problems_.push_back({{{}, 0, 0, pointer}, std::move(message), std::move(expected), std::move(suggestion)});
    }

    void twice(const std::vector<std::string>& names, const char* what) {
        for (size_t i = 0; i < names.size(); ++i)
            if (std::find(names.begin(), names.begin() + static_cast<std::ptrdiff_t>(i), names[i]) !=
                names.begin() + static_cast<std::ptrdiff_t>(i))
                add({}, std::string("two ") + what + " are named '" + names[i] + "'");
    }

    void known(const std::string& pointer, const std::string& name, const std::vector<std::string>& names,
               const std::string& what) {
        if (!name.empty() && std::find(names.begin(), names.end(), name) == names.end())
            add(pointer, "unknown " + what + " '" + name + "'", "a name from /" + what + "s",
                nearest_name(name, names));
    }

    void reference(const TracedReference& reference, const std::string& pointer) {
        const std::filesystem::path name = reference.name;
        if (name.empty() || name.has_parent_path() || reference.name.starts_with('.'))
            add(pointer + "/name", "'" + reference.name + "' names no file",
                "a file name without folder and extension");
        known(pointer, reference.variant, variants_, "variant");
        const std::vector<int32_t>& orders = reference.orders;
        if (!orders.empty() && (orders.size() != 2 || orders[0] < 0 || orders[1] < orders[0]))
            add(pointer + "/orders", "no range of orders", "two whole numbers from 0 on, the lower first");
        if (!orders.empty() && reference.single_scattering)
            add(pointer, "both orders and single_scattering", "one of them");
        if (reference.size != glm::floor(reference.size) || (reference.size.x > 0.0f) != (reference.size.y > 0.0f))
            add(pointer + "/size", "no size", "two whole numbers, or none for the capture's own");
        if (variants_.end() == std::find(variants_.begin(), variants_.end(), reference.variant) &&
            !reference.variant.empty())
            return;
        if (capture_.camera_of(reference).empty() && capture_.cameras.size() > 1)
            add(pointer, "traced from which of the capture's cameras?", "a camera");
    }

    void expectation(const Expectation& wanted, const std::string& pointer) {
        known(pointer, wanted.of, variants_, "variant");
        known(pointer, wanted.equals, variants_, "variant");
        known(pointer, wanted.traced, references_, "reference");
        const bool backed = wanted.reference.starts_with(kReferencesPrefix);
        if (!wanted.reference.empty() && !backed && !wanted.baseline)
            add(pointer, "no truth backs the picture '" + wanted.reference + "'",
                "\"baseline\": true beside it; or a traced reference, or references:NAME");
        if (wanted.baseline && (wanted.reference.empty() || backed))
            add(pointer + "/baseline", "a baseline is a picture beside the capture", "its name as the reference");
        const bool compares = wanted.max_relmse >= 0.0f || wanted.max_mean_error >= 0.0f || wanted.max_flip >= 0.0f ||
                              wanted.max_difference >= 0.0f || wanted.min_z_p >= 0.0f;
        if (compares && wanted.equals.empty() && wanted.reference.empty() && wanted.traced.empty())
            add(pointer, "a limit, but nothing that the picture is held against", "equals, reference or traced");
        if (wanted.min_z_p >= 0.0f && wanted.reference.empty() && wanted.traced.empty())
            add(pointer + "/min_z_p", "a Z-test needs a reference with a variance", "traced or reference");
        if (wanted.min_z_p >= 0.0f && wanted.display)
            add(pointer + "/min_z_p", "a Z-test is of the radiance", "an expectation without display");
    }

    const CaptureFile& capture_;
    std::vector<Diagnostic>& problems_;
    std::vector<std::string> variants_, references_;
};

}  // namespace

CaptureFile load_capture(const std::filesystem::path& file) {
    CaptureFile capture;
    std::vector<Diagnostic> problems;
    const auto type = describe_struct<CaptureFile>("capture");
    const std::string unknown = component_from_json(*type, &capture, paths::read_file(file), problems);
    if (unknown.size() > 2) problems.push_back({{}, "unknown fields " + unknown, "the fields of docs/captures.md"});
    if (capture.variants.empty()) capture.variants.emplace_back();
    Check(capture, problems).all();
    if (capture.scene.empty() && problems.empty()) problems.push_back({{{}, 0, 0, "/scene"}, "no scene is named"});
    for (Diagnostic& problem : problems) problem.where.file = file.string();
    if (!problems.empty()) throw Error(std::move(problems));
    capture.file = file;
    return capture;
}

const CaptureVariant& CaptureFile::variant(const std::string& name) const {
    return called(variants, name, *this, "variant");
}

const TracedReference& CaptureFile::reference(const std::string& name) const {
    return called(references, name, *this, "reference");
}

const CaptureVariant& CaptureFile::variant_of(const TracedReference& reference) const {
    return reference.variant.empty() ? variants.front() : variant(reference.variant);
}

std::string CaptureFile::camera_of(const TracedReference& reference) const {
    if (!reference.camera.empty()) return reference.camera;
    if (const std::string& own = variant_of(reference).camera; !own.empty()) return own;
    return cameras.size() == 1 ? cameras.front() : "";
}

}  // namespace tyndall
