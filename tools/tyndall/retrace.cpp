#include "retrace.h"

#include <fmt/format.h>

#include <chrono>
#include <cstdio>

#include "app/engine.h"
#include "app/reference_recipe.h"
#include "app/stored_reference.h"
#include "core/error.h"
#include "core/paths.h"
#include "reference/trace.h"
#include "traced_reference.h"

namespace tyndall {
namespace fs = std::filesystem;
namespace {

using Clock = std::chrono::steady_clock;

constexpr int64_t kMostBatch = 256, kFewestBatches = 8;
/// With so many batches the noise is known well enough to stop at it.
constexpr int64_t kBatchesForNoise = 16;

reference::TraceSettings settings_of(const CaptureFile& capture, const TracedReference& reference) {
    reference::TraceSettings settings;
    settings.size = size_of(capture, reference);
    settings.seed = static_cast<uint32_t>(reference.seed);
    settings.surfaces_scatter = !reference.no_surfaces;
    settings.media_scatter = !reference.no_media;
    if (reference.single_scattering) settings.max_order = 1;
    if (!reference.orders.empty()) {
        settings.min_order = reference.orders[0];
        settings.max_order = reference.orders[1];
    }
    const int64_t batches = reference.noise > 0.0f ? 2 * kBatchesForNoise : kFewestBatches;
    settings.batch = 1;
    while (settings.batch < kMostBatch && 2 * settings.batch * batches <= reference.samples) settings.batch *= 2;
    return settings;
}

/// The scene of a reference, ready to be traced.
const RenderScene& load(Engine& engine, const CaptureFile& capture, const TracedReference& reference) {
    Assignments changes;
    for (const std::string& text : changes_of(capture, reference)) changes.push_back(split_assignment(text));
    return load_for_tracing(engine, capture.file.parent_path() / capture.scene, changes, capture.camera_of(reference));
}

reference::Film trace(const RenderScene& scene, const CaptureFile& capture, const TracedReference& wanted) {
    const reference::Tracer tracer(scene, settings_of(capture, wanted));
    reference::Film film = tracer.film("");
    Clock::time_point shown = Clock::now();
    for (int64_t batch = 0; film.samples() + film.batch() <= wanted.samples; ++batch) {
        (void)tracer.add_batch(film, batch, [] { return false; });
        if (film.batches() >= kBatchesForNoise && film.noise() <= static_cast<double>(wanted.noise)) break;
        if (film.batches() < 2 || Clock::now() - shown < std::chrono::seconds(10)) continue;
        shown = Clock::now();
        fmt::print(stderr, "{}: {} of at most {} samples, noise {:.2f} %\n", wanted.name, film.samples(),
                   wanted.samples, 100.0 * film.noise());
    }
    return film;
}

/// Why a reference must be traced, or nothing.
std::string reason(const CaptureFile& capture, const TracedReference& reference, const std::string& which) {
    if (which == "all" || which == reference.name) return "asked for";
    if (which != "changed") return {};
    try {
        (void)load_reference(capture, reference);
        return {};
    } catch (const Error& error) {
        return error.diagnostics().front().message;
    }
}

void remake(Engine& engine, const CaptureFile& capture, const TracedReference& wanted) {
    const fs::path file = file_of(capture, wanted);
    const std::string recipe = recipe_of(capture, wanted);  // of the scene as it is now, should it change meanwhile
    const reference::Film film = trace(load(engine, capture, wanted), capture, wanted);
    save_reference(file, {film.radiance(), film.variance()}, recipe, film.samples(), wanted.seed);
    fmt::print("wrote {}: {}x{}, {} samples a pixel, noise {:.2f} %, {} kB\n", file.string(), film.size().x,
               film.size().y, film.samples(), 100.0 * film.noise(), (fs::file_size(file) + 999) / 1000);
    std::fflush(stdout);
}

}  // namespace

void retrace(const CaptureFile& capture, const std::string& which, const fs::path& ocio) {
    if (which != "all" && which != "changed") (void)capture.reference(which);  // throws when it is not there
    Engine engine(false, ocio);
    for (const TracedReference& wanted : capture.references) {
        try {
            const std::string why = reason(capture, wanted, which);
            if (why.empty()) {
                if (which == "changed") fmt::print("{} is as it should be\n", file_of(capture, wanted).string());
                continue;
            }
            fmt::print("tracing {} ({})\n", wanted.name, why);
            std::fflush(stdout);
            remake(engine, capture, wanted);
        } catch (Error& error) {
            throw error.within("tracing " + wanted.name);
        }
    }
}

}  // namespace tyndall
