#pragma once
/// Traced films of scenes, and a folder that keeps them for the next time.

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>

#include "app/engine.h"
#include "reference/film.h"
#include "reference/trace.h"

namespace tyndall {

/// What a film is to show, and how well.
struct TraceRequest {
    std::filesystem::path scene;
    Assignments changes;
    std::string camera;                 ///< empty = the scene's choice
    reference::TraceSettings settings;  ///< its batch is chosen by the samples: see batch_for
    int64_t samples = 64;               ///< a pixel, rounded up to whole batches
};

/// How a trace is followed and stopped; either may be empty.
struct TraceWatch {
    std::function<bool()> cancelled;  ///< asked often, from several threads
    /// After each batch: samples a pixel so far, and those wanted.
    std::function<void(const reference::Film& film, int64_t wanted)> progress;
};

/// Long sequences leave less error, but it takes a few batches to know how much: at least four. 16 for 0 samples.
[[nodiscard]] int batch_for(int64_t samples);

/// Loads a scene into an engine, which needs no renderer, and extracts it. Throws Error for what a tracer would leave
/// out in silence: an asset or a module that is missing, and for a scene without a camera.
const RenderScene& load_for_tracing(Engine& engine, const std::filesystem::path& scene, const Assignments& changes,
                                    const std::string& camera);

/// A folder of films by their recipes.
class FilmCache {
 public:
    /// The folder is made when it is first needed.
    explicit FilmCache(std::filesystem::path folder) : folder_(std::move(folder)) {}

    /// What became of a request.
    struct Found {
        reference::Film film;        ///< with fewer samples than wanted when it was cancelled
        std::filesystem::path file;  ///< where it is kept
        int64_t reused = 0;          ///< samples a pixel that were there
        /// Why a file that was there could not be used, or why the film could not be kept; for people.
        std::string problem;
    };
    /// The film that is kept, gone on with when it has too few samples; otherwise a new one. A file that is damaged is
    /// replaced, and while a long trace goes on the film is saved now and then. Throws Error for a scene that cannot be
    /// traced, and before tracing when the film could not be kept.
    [[nodiscard]] Found film(const TraceRequest& request, const TraceWatch& watch = {}) const;

 private:
    std::filesystem::path folder_;
};

}  // namespace tyndall
