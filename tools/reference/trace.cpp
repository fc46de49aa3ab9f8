#include "reference/trace.h"

#include <atomic>
#include <cmath>

#include "core/error.h"
#include "core/parallel.h"
#include "physics/physics.h"
#include "reference/path.h"

namespace tyndall::reference {
namespace {

using glm::vec3;

float unit_of(const Camera& camera) {
    const float exposure = camera.exposure.value_or(physics::exposure_from_ev100(camera.ev100));
    return std::exp2(std::round(-std::log2(std::max(exposure, 1e-20f))));
}

Ray camera_ray(const Camera& camera, glm::ivec2 size, glm::vec2 at) {
    const float half = std::tan(0.5f * camera.vertical_fov);
    const auto width = static_cast<float>(size.x), height = static_cast<float>(size.y);
    const vec3 direction = -vec3(camera.transform[2]) +
                           vec3(camera.transform[0]) * ((2.0f * at.x / width - 1.0f) * half * width / height) +
                           vec3(camera.transform[1]) * ((1.0f - 2.0f * at.y / height) * half);
    return {vec3(camera.transform[3]), glm::normalize(direction)};
}

void check(const TraceSettings& settings) {
    check_image_size(settings.size.x, settings.size.y, 3, Image::Type::f32);
    if (settings.batch < 1 || settings.batch > 65536 || (settings.batch & (settings.batch - 1)) != 0)
        throw Error("a batch is of " + std::to_string(settings.batch) +
                    " samples: it must be a power of two up to 65536");
    if (settings.min_order > settings.max_order)
        throw Error("no light is scattered at least " + std::to_string(settings.min_order) + " and at most " +
                    std::to_string(settings.max_order) + " times");
}

}  // namespace

struct Tracer::Implementation {
    Implementation(const RenderScene& scene, const TraceSettings& wanted)
        : settings(wanted),
          world(scene),
          tracer(world, with_unit(wanted, unit_of(scene.camera))),
          unit(unit_of(scene.camera)) {}

    static TraceSettings with_unit(TraceSettings settings, float unit) {
        settings.clamp *= unit;
        return settings;
    }

    Film::PixelBatch pixel(glm::ivec2 at, int64_t batch, std::vector<MediaRay::Stretch>& stretches) const {
        glm::dvec3 sums[6] = {};
        uint64_t cast = 0, met = 0;
        for (int i = 0; i < settings.batch; ++i) {
            Sampler sampler(glm::uvec2(at), settings.seed, static_cast<uint64_t>(batch), static_cast<uint32_t>(i));
            const Ray ray = camera_ray(world.camera(), settings.size, glm::vec2(at) + sampler.next2());
            const PathResult found = tracer.trace(ray, sampler, stretches);
            const vec3* values[6] = {&found.values.radiance, &found.values.albedo,  &found.values.normal,
                                     &found.values.emission, &found.values.surface, &found.values.medium};
            for (int k = 0; k < 6; ++k) sums[k] += glm::dvec3(*values[k]);
            cast += found.rays;
            met += found.events;
        }
        rays += cast;
        events += met;
        const double share = 1.0 / settings.batch;
        return {vec3(sums[0] * share), vec3(sums[1] * share), vec3(sums[2] * share),
                vec3(sums[3] * share), vec3(sums[4] * share), vec3(sums[5] * share)};
    }

    TraceSettings settings;
    TracedWorld world;
    PathTracer tracer;
    float unit;
    mutable std::atomic<uint64_t> rays{0}, events{0};
};

Tracer::Tracer(const RenderScene& scene, const TraceSettings& settings) {
    check(settings);
    self_ = std::make_unique<Implementation>(scene, settings);
}
Tracer::~Tracer() = default;
Tracer::Tracer(Tracer&&) noexcept = default;
Tracer& Tracer::operator=(Tracer&&) noexcept = default;

Film Tracer::film(std::string recipe) const {
    return {self_->settings.size, self_->settings.batch, self_->unit, std::move(recipe), self_->settings.components};
}

bool Tracer::add_batch(Film& film, int64_t batch, FunctionRef<bool()> cancelled) const {
    constexpr int kTile = 16;
    const glm::ivec2 size = self_->settings.size, tiles = (size + kTile - 1) / kTile;
    std::vector<Film::PixelBatch> pixels(static_cast<size_t>(size.x) * static_cast<size_t>(size.y));
    std::atomic<bool> stop{false};
    parallel_for(0, static_cast<size_t>(tiles.x) * static_cast<size_t>(tiles.y), 1, [&](size_t first, size_t last) {
        std::vector<MediaRay::Stretch> stretches;
        for (size_t tile = first; tile < last && !stop; ++tile) {
            const glm::ivec2 low =
                kTile * glm::ivec2(static_cast<int>(tile) % tiles.x, static_cast<int>(tile) / tiles.x);
            const glm::ivec2 high = glm::min(low + kTile, size);
            for (int y = low.y; y < high.y; ++y)
                for (int x = low.x; x < high.x; ++x)
                    pixels[static_cast<size_t>(y) * static_cast<size_t>(size.x) + static_cast<size_t>(x)] =
                        self_->pixel({x, y}, batch, stretches);
            if (cancelled()) stop = true;
        }
    });
    if (stop) return false;
    for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x)
            film.add({x, y}, pixels[static_cast<size_t>(y) * static_cast<size_t>(size.x) + static_cast<size_t>(x)]);
    film.finish_batch(batch);
    return true;
}

uint64_t Tracer::rays() const {
    return self_->rays;
}
uint64_t Tracer::events() const {
    return self_->events;
}
float Tracer::unit() const {
    return self_->unit;
}

Film trace(const RenderScene& scene, const TraceSettings& settings, int64_t samples) {
    const Tracer tracer(scene, settings);
    Film film = tracer.film("");
    for (int64_t batch = 0; batch * settings.batch < samples; ++batch)
        tracer.add_batch(film, batch, [] { return false; });
    return film;
}

}  // namespace tyndall::reference
