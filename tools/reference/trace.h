#pragma once
/// The reference path tracer: unbiased light transport through a RenderScene, on the CPU.
///
/// The result depends on the scene and the settings alone, bit for bit: not on threads, tiles, shards, or how often a
/// trace was interrupted and resumed.

#include <cstdint>
#include <glm/vec2.hpp>
#include <limits>
#include <memory>
#include <string>

#include "core/function_ref.h"
#include "reference/film.h"
#include "scene/render_scene.h"

namespace tyndall::reference {

/// How a picture is traced. Two films fit together (merge, resume) when these are equal.
struct TraceSettings {
    glm::ivec2 size{640, 360};
    uint32_t seed = 0;
    int batch = 16;  ///< samples of a pixel that share one low-discrepancy sequence; a power of two
    /// Light that was scattered fewer or more times than this is left out. Emission seen directly has 0, light that a
    /// surface or a medium scattered once has 1. Passing a smooth dielectric boundary does not count.
    int min_order = 0;
    int max_order = std::numeric_limits<int>::max();  ///< 1 = single scattering: what the real-time passes approximate
    bool surfaces_scatter = true;                     ///< off: surfaces are black, for the medium's light alone
    bool media_scatter = true;                        ///< off: media only absorb and emit
    float clamp = 0.0f;       ///< largest luminance of one sample in units of the exposure's white; 0 = unbiased
    bool components = false;  ///< also films emission, surface, medium and multiple, which add up to the radiance
};

/// Traces batches of samples of one picture.
class Tracer {
 public:
    /// Copies what it needs of the scene. Throws Error for what it cannot trace.
    Tracer(const RenderScene& scene, const TraceSettings& settings);
    ~Tracer();
    Tracer(Tracer&&) noexcept;
    Tracer& operator=(Tracer&&) noexcept;

    /// A film of these settings without samples. `recipe` tells films of other scenes and settings from it.
    [[nodiscard]] Film film(std::string recipe) const;
    /// Adds batch number `batch` of every pixel, over all cores. Returns false when `cancelled` said so: the film is
    /// then as it was before.
    bool add_batch(Film& film, int64_t batch, FunctionRef<bool()> cancelled) const;
    /// Rays cast, and meetings with surfaces and media, since construction.
    [[nodiscard]] uint64_t rays() const;
    [[nodiscard]] uint64_t events() const;
    /// Radiance (cd/m2) that the camera's exposure makes white, to the nearest power of two.
    [[nodiscard]] float unit() const;

 private:
    struct Implementation;
    std::unique_ptr<Implementation> self_;
};

/// Traces `samples` per pixel, rounded up to whole batches: for captures and tests.
[[nodiscard]] Film trace(const RenderScene& scene, const TraceSettings& settings, int64_t samples);

}  // namespace tyndall::reference
