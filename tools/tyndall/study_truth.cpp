#include "study_truth.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/expectations.h"
#include "core/error.h"
#include "image/image_io.h"

namespace tyndall {
namespace fs = std::filesystem;
namespace {

using measure::Reference;
using measure::Study;
using measure::StudyScene;

Truth loaded(const Study& study, const StudyScene& scene) {
    const auto found = reference_picture(study.file.parent_path(), scene.reference.file);
    if (!found)
        throw Error("the folder of references is not there (set TYNDALL_REFERENCES to the folder of " +
                    scene.reference.file + ")");
    const fs::path& file = *found;
    Truth truth;
    truth.picture.radiance = with_channels(to_float(load_image(file)), 3);
    const auto wanted = glm::ivec2(scene.size);
    if (truth.picture.radiance.width != wanted.x || truth.picture.radiance.height != wanted.y)
        throw Error(Diagnostic{
            {file.string()},
            fmt::format("the reference has {}x{} pixels", truth.picture.radiance.width, truth.picture.radiance.height),
            fmt::format("the scene's size, {}x{}", wanted.x, wanted.y)});
    if (std::ranges::count(load_layer_names(file), "variance") > 0)
        truth.picture.variance = load_layer(file, "variance");
    else if (scene.reference.noise >= 0.0f)
        truth.picture.variance =
            variance_of_relative_noise(truth.picture.radiance, static_cast<double>(scene.reference.noise));
    truth.about = truth.identity = scene.reference.file;
    return truth;
}

TraceRequest request_of(const Study& study, const StudyScene& scene) {
    const Reference& reference = scene.reference;
    TraceRequest request;
    request.scene = study.file.parent_path() / scene.scene;
    request.changes = assignments(scene.set);
    for (const auto& change : assignments(reference.set)) request.changes.push_back(change);
    request.camera = scene.camera;
    request.settings.size = glm::ivec2(scene.size);
    request.settings.min_order = reference.min_order;
    if (reference.max_order >= 0) request.settings.max_order = reference.max_order;
    request.settings.surfaces_scatter = reference.surfaces;
    request.settings.media_scatter = reference.media;
    request.samples = reference.spp;
    return request;
}

std::string about(const Reference& reference, int64_t samples) {
    std::string text = fmt::format("traced with {} samples a pixel", samples);
    if (reference.min_order > 0 || reference.max_order >= 0)
        text += reference.max_order < 0 ? fmt::format(", orders from {} on", reference.min_order)
                : reference.min_order == reference.max_order
                    ? fmt::format(", order {} alone", reference.min_order)
                    : fmt::format(", orders {} to {}", reference.min_order, reference.max_order);
    if (!reference.surfaces) text += ", by media alone";
    if (!reference.media) text += ", by surfaces alone";
    return text;
}

/// to += factor * what.
void combine(Image& to, const Image& what, float factor) {
    for (size_t i = 0; i < to.value_count(); ++i) to.floats()[i] += factor * what.floats()[i];
}

}  // namespace

Truth truth_of(const Study& study, const StudyScene& scene, const FilmCache& films, const TraceWatch& watch) {
    if (!scene.reference.file.empty()) return loaded(study, scene);
    TraceRequest request = request_of(study, scene);
    FilmCache::Found found = films.film(request, watch);
    Truth truth;
    truth.complete = found.film.samples() >= request.samples;
    truth.picture = {found.film.radiance(), found.film.variance()};
    truth.about = about(scene.reference, found.film.samples());
    truth.identity = fmt::format("{} {}", found.film.recipe(), found.film.samples());
    truth.problem = std::move(found.problem);
    if (scene.reference.subtract.empty() || !truth.complete) return truth;
    for (const auto& change : assignments(scene.reference.subtract)) request.changes.push_back(change);
    found = films.film(request, watch);
    truth.complete = found.film.samples() >= request.samples;
    combine(truth.picture.radiance, found.film.radiance(), -1.0f);
    combine(truth.picture.variance, found.film.variance(), 1.0f);
    truth.about += ", less what is not compared";
    truth.identity += fmt::format(" less {} {}", found.film.recipe(), found.film.samples());
    truth.problem += found.problem;
    return truth;
}

Assignments assignments(const std::vector<std::string>& texts) {
    Assignments all;
    for (const std::string& text : texts) all.push_back(split_assignment(text));
    return all;
}

}  // namespace tyndall
