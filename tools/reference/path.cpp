#include "reference/path.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "reference/path_state.h"

namespace tyndall::reference {

using glm::vec3;

namespace {

constexpr int kTurnsBeforeRoulette = 4;

}  // namespace

PathTracer::PathTracer(const TracedWorld& world, const TraceSettings& settings) : world_(world), settings_(settings) {
    all_positional_ = true;
    for (size_t i = 0; i < world_.lights().count(); ++i)
        all_positional_ = all_positional_ && world_.lights().positional(i);
}

void PathTracer::add(Path& path, const vec3& value, int order, int first) const {
    if (order < settings_.min_order || order > settings_.max_order) return;
    Film::PixelBatch& values = path.result.values;
    values.radiance += value;
    if (order == 0) values.emission += value;
    if (order == 1) (first == 1 ? values.surface : values.medium) += value;
}

bool PathTracer::roulette(Path& path) const {
    if (++path.turns > kMostTurns) return false;
    if (path.turns <= kTurnsBeforeRoulette) return true;
    const float survival = largest(path.weight()) * path.bent;
    if (survival >= 1.0f) return true;
    if (!(path.sampler.next_independent() < survival)) return false;
    path.f /= survival;
    return true;
}

bool PathTracer::turn(Path& path, const vec3& direction, float pdf, const vec3& place, bool specular) const {
    path.ray.direction = direction;
    path.camera = false;
    path.specular = specular;
    path.turn_pdf = pdf;
    path.turn_place = place;
    return roulette(path);
}

PathResult PathTracer::trace(const Ray& ray, Sampler& sampler, std::vector<MediaRay::Stretch>& stretches) const {
    Path path{.ray = ray, .nesting = world_.camera_nesting(), .sampler = sampler, .stretches = stretches};
    path.hero = std::min(static_cast<int>(sampler.next() * 3.0f), 2);
    while (step(path)) {
    }
    if (settings_.clamp > 0.0f) {
        const float luminance = physics::luminance_rec709(path.result.values.radiance);
        if (luminance > settings_.clamp) path.result.values.radiance *= settings_.clamp / luminance;
    }
    return path.result;
}

bool PathTracer::step(Path& path) const {
    if (const MediumVolume* medium = world_.even_interior(path.nesting)) return step_inside(path, *medium);
    Hit hit;
    const bool met = world_.geometry().intersect(path.ray, RayMask::all, hit);
    ++path.result.rays;
    const float end = met ? hit.distance_m : std::numeric_limits<float>::infinity();
    const MediaRay media = world_.media(path.ray, end, path.nesting);
    if (!media.empty() && path.nesting.empty()) light_along(path, media);
    if (world_.lights().any_sized()) meet_lights(path, media, end, false);
    if (!media.empty()) {
        // nothing more can be found where a flight would end: what arrives is dimmed instead
        const bool last = path.order >= settings_.max_order || !settings_.media_scatter ||
                          (path.order + 1 == settings_.max_order && path.nesting.empty() && path.turns == 0 &&
                           !world_.lights().any_sized());
        if (last && !media.emits()) {
            path.f *= media.transmittance(end, path.sampler);
        } else {
            float t = 0.0f;
            MediumPoint point;
            vec3 glow(0.0f);
            const bool collided = media.fly(end, path.hero, path.sampler, path.f, path.ratio, t, point, glow);
            if (media.emits()) add(path, glow, path.order, path.first);
            if (collided) return scatter_in_medium(path, t, point);
        }
    }
    if (met) return meet_surface(path, hit);
    meet_lights(path, media, end, true);
    return false;
}

bool PathTracer::step_inside(Path& path, const MediumVolume& medium) const {
    const float sigma = medium.sigma_t[path.hero];
    const float flight =
        sigma > 0.0f ? -std::log(1.0f - path.sampler.next()) / sigma : std::numeric_limits<float>::infinity();
    // A place closer to the boundary than rounding can tell would leave the mesh: it is drawn back.
    const vec3 size = glm::abs(path.ray.origin);
    const float margin = 1e-5f * flight + 1e-6f * largest(size);
    Hit hit;
    path.ray.far_m = flight + margin;
    bool met = world_.geometry().intersect(path.ray, RayMask::all, hit);
    path.ray.far_m = std::numeric_limits<float>::infinity();
    ++path.result.rays;
    if (!met && flight == path.ray.far_m) return false;  // out through a hole in the mesh
    const bool close = met && hit.distance_m >= flight;
    const float end = close ? std::max(0.0f, std::min(flight, hit.distance_m - margin)) : met ? hit.distance_m : flight;
    met = met && !close;
    MediaRay media(path.ray);
    media.fill(medium, end);
    if (world_.lights().any_sized()) meet_lights(path, media, end, false);
    const vec3 passed = glm::exp(-(medium.sigma_t - vec3(sigma)) * end);  // over the hero's
    path.f *= passed;
    path.ratio *= passed;
    if (met) return meet_surface(path, hit);
    path.f /= sigma;
    path.ratio *= medium.sigma_t / sigma;
    MediumPoint point;
    point.parts[point.count++] = {&medium, 1.0f};
    point.sigma_s = medium.sigma_s, point.sigma_t = medium.sigma_t;
    return scatter_in_medium(path, end, point);
}

void PathTracer::meet_lights(Path& path, const MediaRay& media, float end, bool missed) const {
    if (missed && path.camera) {
        add(path, path.weight() * world_.lights().background(path.ray.direction), path.order, path.first);
        return;
    }
    if (path.camera) return;  // sources show in what they light and in mirrors, not by themselves
    const Lights& lights = world_.lights();
    Ray ray = path.ray;
    ray.far_m = end;
    lights.met(ray, missed, [&](size_t light, const vec3& radiance, float pdf, float metres) {
        if (std::isinf(metres) != missed) return;
        vec3 value = path.weight() * radiance;
        if (!path.specular) value *= power_weight(path.turn_pdf, lights.probability_at(light, path.turn_place) * pdf);
        if (!missed && !media.empty()) value *= media.transmittance(metres, path.sampler);
        add(path, value, path.order, path.first);
    });
}

}  // namespace tyndall::reference
