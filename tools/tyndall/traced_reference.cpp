#include "traced_reference.h"

#include <chrono>
#include <optional>

#include "app/reference_recipe.h"
#include "core/error.h"
#include "trace_recipe.h"

namespace tyndall {
namespace fs = std::filesystem;

using reference::Film;
using reference::Tracer;

int batch_for(int64_t samples) {
    if (samples == 0) return 16;
    int batch = 1;
    while (batch < 256 && batch * 8 <= samples) batch *= 2;
    return batch;
}

const RenderScene& load_for_tracing(Engine& engine, const fs::path& scene, const Assignments& changes,
                                    const std::string& camera) {
    engine.load_scene(scene, changes);
    engine.select_camera(camera);
    const RenderScene& extracted = engine.extract();
    if (!engine.unmade().empty()) throw Error(engine.unmade());
    if (const std::string problem = engine.problems(); !problem.empty())
        throw Error("nothing was traced, since a part of the scene is missing: " + problem);
    if (extracted.cameras.empty()) throw Error(scene.string() + ": the scene has no camera to trace from");
    return extracted;
}

namespace {

constexpr std::chrono::seconds kCheckpoint{30};

/// Adds batches until the film has the samples; `after_batch` may keep it meanwhile.
void go_on(const Tracer& tracer, Film& film, int64_t samples, const TraceWatch& watch,
           const std::function<void()>& after_batch) {
    const auto cancelled = [&] { return watch.cancelled && watch.cancelled(); };
    for (int64_t batch = 0; film.samples() < samples && !cancelled(); ++batch) {
        if (film.has(batch)) continue;
        if (!tracer.add_batch(film, batch, cancelled)) return;
        after_batch();
        if (watch.progress) watch.progress(film, samples);
    }
}

/// The film in `file` if it was made by this recipe, in whatever batches. Says in `problem` why not, where there is
/// one.
std::optional<Film> kept_film(const fs::path& file, const Engine& engine, const TraceRequest& request,
                              std::string& problem) {
    if (!fs::exists(file)) return std::nullopt;
    try {
        Film film = Film::load(file);
        reference::TraceSettings settings = request.settings;
        settings.batch = film.batch();
        if (film.recipe() == trace_recipe(engine, request.camera, settings)) return film;
        problem = file.string() + ": holds another picture than its name says, and is made anew";
    } catch (const Error& error) {
        problem = std::string(error.what()) + "; it is made anew";
    }
    return std::nullopt;
}

void save(const Film& film, const fs::path& file) {
    std::error_code failed;
    fs::create_directories(file.parent_path(), failed);
    if (failed) throw Error(Diagnostic{{file.parent_path().string()}, "cannot make the folder: " + failed.message()});
    film.save(file);
}

}  // namespace

FilmCache::Found FilmCache::film(const TraceRequest& request, const TraceWatch& watch) const {
    Engine engine(false);
    const RenderScene& scene = load_for_tracing(engine, request.scene, request.changes, request.camera);
    reference::TraceSettings settings = request.settings;
    settings.batch = 0;  // a film in other batches is as good
    const std::string name = content_hash(trace_recipe(engine, request.camera, settings));
    Found found;
    found.file = folder_ / (request.scene.stem().string() + "-" + name + ".exr");
    std::optional<Film> kept = kept_film(found.file, engine, request, found.problem);
    settings.batch = kept ? kept->batch() : batch_for(request.samples);
    if (kept) found.reused = kept->samples();
    if (kept && kept->samples() >= request.samples) {
        found.film = std::move(*kept);
        return found;
    }
    const Tracer tracer(scene, settings);
    found.film = kept ? std::move(*kept) : tracer.film(trace_recipe(engine, request.camera, settings));
    save(found.film, found.file);  // a place that cannot be written is better known before than after
    auto saved = std::chrono::steady_clock::now();
    const auto keep = [&] {
        try {
            saved = std::chrono::steady_clock::now();
            save(found.film, found.file);
        } catch (const Error& error) {
            found.problem = std::string(error.what()) + "; the film that was traced is used, but not kept";
        }
    };
    go_on(tracer, found.film, request.samples, watch, [&] {
        if (std::chrono::steady_clock::now() - saved > kCheckpoint) keep();
    });
    keep();
    return found;
}

}  // namespace tyndall
