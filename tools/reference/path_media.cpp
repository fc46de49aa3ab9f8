// Light that media of the air and of solids scatter.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "physics/physics.h"
#include "reference/path_state.h"

namespace tyndall::reference {

using glm::vec2;
using glm::vec3;

namespace {

/// Density of physics::sample_equi_angular at `t`, 1/m.
float equi_angular_pdf(float t, float t0, float t1, const Ray& ray, const vec3& centre) {
    const vec3 offset = centre - ray.origin;
    const float foot = glm::dot(offset, ray.direction);
    const float d = std::max(glm::length(offset - foot * ray.direction), 1e-3f);
    const float range = std::atan((t1 - foot) / d) - std::atan((t0 - foot) / d);
    return d / (range * (d * d + (t - foot) * (t - foot)));
}

/// Where `wanted` of the light that all stretches take is taken.
float place_at(const std::vector<MediaRay::Stretch>& stretches, float wanted) {
    for (const MediaRay::Stretch& s : stretches) {
        if (wanted < s.mass()) return s.place_of(wanted);
        wanted -= s.mass();
    }
    return stretches.back().to;
}
/// Where `wanted` metres of them have passed.
float place_along(const std::vector<MediaRay::Stretch>& stretches, float wanted) {
    for (const MediaRay::Stretch& s : stretches) {
        if (wanted < s.length()) return s.from + wanted;
        wanted -= s.length();
    }
    return stretches.back().to;
}

}  // namespace

float PathTracer::draw_distance(Path& path, const MediaRay& media, size_t light, float t0, float t1, float& pdf) const {
    media.stretches(t0, t1, path.stretches);
    float mass = 0.0f, length = 0.0f;
    for (const MediaRay::Stretch& s : path.stretches) mass += s.mass(), length += s.length();
    pdf = 0.0f;
    if (!(mass > 0.0f)) return t0;
    // Half of all look where the light is near; or, for light from afar in uneven media, anywhere: it may fall where
    // the medium is thinnest.
    const Lights& lights = world_.lights();
    const bool near = lights.positional(light), uneven = path.stretches.size() > 1;
    const vec3 centre = near ? lights.position(light) : vec3(0.0f);
    vec2 xi = path.sampler.next2();
    float t = t0;
    if (xi.y >= 0.5f || !(near || uneven)) {
        t = place_at(path.stretches, xi.x * mass);
    } else if (near) {
        float angular = 0.0f;
        t = physics::sample_equi_angular(xi.x, t0, t1, path.ray.origin, path.ray.direction, centre, angular);
    } else {
        t = place_along(path.stretches, xi.x * length);
    }
    const auto here = std::find_if(path.stretches.begin(), path.stretches.end(),
                                   [&](const MediaRay::Stretch& s) { return t >= s.from && t <= s.to; });
    const bool inside = here != path.stretches.end();
    pdf = inside ? here->sigma * here->transmittance * std::exp(-here->sigma * (t - here->from)) / mass : 0.0f;
    if (near)
        pdf = 0.5f * (pdf + equi_angular_pdf(t, t0, t1, path.ray, centre));
    else if (uneven)
        pdf = 0.5f * (pdf + (inside ? 1.0f / length : 0.0f));
    return t;
}

void PathTracer::light_along(Path& path, const MediaRay& media) const {
    if (!settings_.media_scatter || path.order + 1 > settings_.max_order) return;
    const Lights& lights = world_.lights();
    const bool all = path.turns == 0;  // later, lights without a place are looked for where flights end
    float low = 0.0f, high = 0.0f;
    media.extent(low, high);
    float sum = 0.0f;
    const auto weight_of = [&](size_t i, float& t0, float& t1) {
        t0 = low, t1 = high;
        return all || lights.positional(i) ? lights.weight_along(i, path.ray, t0, t1) : 0.0f;
    };
    float t0 = 0.0f, t1 = 0.0f;
    for (size_t i = 0; i < lights.count(); ++i) sum += weight_of(i, t0, t1);
    if (!(sum > 0.0f)) return;
    float left = lights.count() > 1 ? path.sampler.next() * sum : 0.0f, weight = 0.0f;
    size_t light = 0;
    for (size_t i = 0; i < lights.count(); ++i) {
        const float w = weight_of(i, t0, t1);
        if (w <= 0.0f) continue;
        light = i, weight = w;
        left -= w;
        if (left < 0.0f) break;
    }
    weight_of(light, t0, t1);
    float pdf = 0.0f;
    const float t = draw_distance(path, media, light, t0, t1, pdf);
    if (!(pdf > 0.0f)) return;
    const MediumPoint point = media.at(t);
    if (point.count == 0) return;
    const vec3 place = path.ray.origin + path.ray.direction * t;
    LightSample sample;
    if (!lights.sample(light, place, lights.sized(light) ? path.sampler.next2() : vec2(0.0f), sample)) return;
    const float u = glm::dot(sample.direction, path.ray.direction);
    vec3 value = point.scattering(u) * sample.light * path.weight() * (sum / (weight * pdf));
    const float mis =
        sample.pdf > 0.0f ? power_weight(lights.probability_at(light, place) * sample.pdf, point.pdf(u)) : 1.0f;
    if (value == vec3(0.0f)) return;
    ++path.result.rays;
    value *= world_.visibility(nullptr, place, sample, path.nesting, mis, path.sampler);
    if (value == vec3(0.0f)) return;
    add(path, value * media.transmittance(t, path.sampler), path.order + 1, path.order == 0 ? 2 : path.first);
}

void PathTracer::light_at_medium(Path& path, const vec3& place, const MediumPoint& point) const {
    const bool air = path.nesting.empty();
    if (path.order + 1 > settings_.max_order) return;
    if (air && (path.turns == 0 || all_positional_)) return;
    const Lights& lights = world_.lights();
    size_t light = 0;
    float probability = 0.0f;
    if (lights.count() == 0 ||
        !lights.choose_at(lights.count() > 1 ? path.sampler.next() : 0.0f, place, light, probability))
        return;
    if (air && lights.positional(light)) return;
    LightSample sample;
    if (!lights.sample(light, place, lights.sized(light) ? path.sampler.next2() : vec2(0.0f), sample)) return;
    const float u = glm::dot(sample.direction, path.ray.direction);
    vec3 value = point.scattering(u) * sample.light * path.weight() / probability;
    const float mis = sample.pdf > 0.0f ? power_weight(probability * sample.pdf, point.pdf(u)) : 1.0f;
    if (value == vec3(0.0f)) return;
    ++path.result.rays;
    value *= world_.visibility(nullptr, place, sample, path.nesting, mis, path.sampler);
    add(path, value, path.order + 1, path.order == 0 ? 2 : path.first);
}

bool PathTracer::scatter_in_medium(Path& path, float t, const MediumPoint& point) const {
    ++path.result.events;
    if (!settings_.media_scatter || path.order + 1 > settings_.max_order || largest(point.sigma_s) <= 0.0f)
        return false;
    const vec3 place = path.ray.origin + path.ray.direction * t;
    light_at_medium(path, place, point);
    if (path.order + 1 >= settings_.max_order && !world_.lights().any_sized()) return false;
    vec3 scattering;
    const float u = point.sample(path.sampler, scattering);
    const vec3 direction = physics::direction_about(path.ray.direction, u, path.sampler.next());
    path.f *= scattering;
    if (path.order == 0) path.first = 2;
    ++path.order;
    path.ray.origin = place;
    return turn(path, glm::normalize(direction), point.pdf(u), place, false);
}

}  // namespace tyndall::reference
