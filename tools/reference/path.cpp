#include "reference/path.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "reference/rough_boundary.h"

namespace tyndall::reference {
namespace {

using glm::vec2;
using glm::vec3;

constexpr int kMostTurns = 100000;  ///< far beyond any path that roulette lets live
constexpr int kTurnsBeforeRoulette = 4;

float mean_of(const vec3& v) {
    return (v.x + v.y + v.z) / 3.0f;
}
float largest(const vec3& v) {
    return std::max(v.x, std::max(v.y, v.z));
}

/// Power heuristic: the weight of a strategy of density `a` beside one of density `b`.
float power_weight(float a, float b) {
    if (!(a > 0.0f)) return 0.0f;
    const float r = b / a;
    return 1.0f / (1.0f + r * r);
}

/// Density of physics::sample_equi_angular at `t`, 1/m.
float equi_angular_pdf(float t, float t0, float t1, const Ray& ray, const vec3& centre) {
    const vec3 offset = centre - ray.origin;
    const float foot = glm::dot(offset, ray.direction);
    const float d = std::max(glm::length(offset - foot * ray.direction), 1e-3f);
    const float range = std::atan((t1 - foot) / d) - std::atan((t0 - foot) / d);
    return d / (range * (d * d + (t - foot) * (t - foot)));
}

}  // namespace

struct PathTracer::Path {
    Ray ray;
    vec3 f{1.0f};      ///< contribution over the hero channel's density
    vec3 ratio{1.0f};  ///< each channel's density over the hero's
    int hero = 0;
    Nesting nesting;
    int order = 0;  ///< times scattered
    int first = 0;  ///< what scattered first: 1 a surface, 2 a medium
    int turns = 0;
    bool camera = true;    ///< has gone straight from the camera
    bool specular = true;  ///< the last turn was a mirror's, or there was none: no other strategy finds what it meets
    float turn_pdf = 0.0f;
    vec3 turn_place{0.0f};
    Sampler& sampler;
    std::vector<MediaRay::Stretch>& stretches;
    PathResult result;
    float bent = 1.0f;  ///< what refraction will scale back when the path leaves again
    bool seen = false;  ///< albedo and normal are known

    [[nodiscard]] vec3 weight() const { return f / mean_of(ratio); }
};

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

// Media ------------------------------------------------------------------------------------------------------------

namespace {

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

// Lights that a path meets -------------------------------------------------------------------------------------------

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

void PathTracer::add_emission(Path& path, const Hit& hit, const SurfacePoint& point) const {
    const Lights& lights = world_.lights();
    const vec3 emitted = lights.emitted(hit.surface, point, -path.ray.direction);
    if (emitted == vec3(0.0f)) return;
    vec3 value = path.weight() * emitted;
    if (!path.specular && lights.triangles_light() < lights.count())
        value *= power_weight(path.turn_pdf, lights.probability_at(lights.triangles_light(), path.turn_place) *
                                                 lights.triangle_pdf(hit, point, path.turn_place));
    add(path, value, path.order, path.first);
}

// Surfaces -----------------------------------------------------------------------------------------------------------

bool PathTracer::meet_surface(Path& path, const Hit& hit) const {
    ++path.result.events;
    const SurfacePoint point = world_.geometry().point(hit);
    if (world_.surfaces()[hit.surface].interior) return meet_boundary(path, point, hit.surface);
    return meet_standard(path, hit, point);
}

bool PathTracer::pass_straight(Path& path, const SurfacePoint& point, const vec3& through) const {
    path.f *= through;
    path.ray.origin = offset_origin(point, path.ray.direction);
    return ++path.turns <= kMostTurns;
}

template <class Bsdf>
void PathTracer::light_at_surface(Path& path, const SurfacePoint& point, const Bsdf& bsdf,
                                  const Nesting& other_side) const {
    const Lights& lights = world_.lights();
    if (path.order + 1 > settings_.max_order || lights.count() == 0) return;
    size_t light = 0;
    float probability = 0.0f;
    const float choice = lights.count() > 1 ? path.sampler.next() : 0.0f;
    if (!lights.choose_at(choice, point.position, light, probability)) return;
    LightSample sample;
    if (!lights.sample(light, point.position, lights.sized(light) ? path.sampler.next2() : vec2(0.0f), sample)) return;
    float pdf = 0.0f;
    vec3 value = bsdf.evaluate(sample.direction, pdf) * sample.light * path.weight() / probability;
    const float mis = sample.pdf > 0.0f ? power_weight(probability * sample.pdf, pdf) : 1.0f;
    if (value == vec3(0.0f)) return;
    ++path.result.rays;
    const bool crosses = (glm::dot(sample.direction, point.geometric_normal) > 0.0f) !=
                         (glm::dot(path.ray.direction, point.geometric_normal) < 0.0f);
    value *= world_.visibility(&point, point.position, sample, crosses ? other_side : path.nesting, mis, path.sampler);
    add(path, value, path.order + 1, path.order == 0 ? 1 : path.first);
}

namespace {

/// A BSDF whose directions agree with the real sides of the surface: interpolated and mapped normals may not.
template <class Inner>
struct OnRealSides {
    const Inner& inner;
    vec3 side;  ///< geometric normal on the path's side
    [[nodiscard]] bool agrees(const vec3& l) const {
        return (glm::dot(l, side) > 0.0f) == (glm::dot(l, inner.normal()) > 0.0f);
    }
    [[nodiscard]] vec3 evaluate(const vec3& l, float& pdf) const {
        pdf = 0.0f;
        return agrees(l) ? vec3(inner.evaluate(l, pdf)) : vec3(0.0f);
    }
};

}  // namespace

bool PathTracer::meet_standard(Path& path, const Hit& hit, const SurfacePoint& point) const {
    const Material& material = *world_.surfaces()[hit.surface].material;
    const vec3 v = -path.ray.direction;
    const bool back = glm::dot(v, point.geometric_normal) < 0.0f;
    if (back && path.camera && !material.double_sided) return pass_straight(path, point, vec3(1.0f));
    const MaterialPoint m = material_at(material, point);
    vec3 n = back ? -m.normal : m.normal;
    const vec3 side = back ? -point.geometric_normal : point.geometric_normal;
    if (glm::dot(n, v) <= 0.0f) n = side;
    const StandardBsdf bsdf(m, world_.albedo(), n, v);
    vec3 through(1.0f - m.opacity);
    if (m.thin_transmission > 0.0f) through += m.opacity * bsdf.base_transmission();
    float reflects = 1.0f;
    if (largest(through) > 0.0f) {
        const float passing = m.thin_transmission > 0.0f ? std::clamp(mean_of(through), 0.1f, 0.9f) : 1.0f - m.opacity;
        if (path.sampler.next() < passing) return pass_straight(path, point, through / passing);
        reflects = m.opacity / (1.0f - passing);
    }
    path.f *= reflects;
    if (!path.seen) {
        path.seen = true;
        path.result.values.albedo = m.base_colour;
        path.result.values.normal = n;
    }
    add_emission(path, hit, point);
    return scatter_at_surface(path, point, bsdf, side);
}

bool PathTracer::scatter_at_surface(Path& path, const SurfacePoint& point, const StandardBsdf& bsdf,
                                    const vec3& side) const {
    if (!settings_.surfaces_scatter || path.order + 1 > settings_.max_order) return false;
    const OnRealSides<StandardBsdf> real{bsdf, side};
    light_at_surface(path, point, real, path.nesting);
    if (path.order + 1 >= settings_.max_order && !world_.lights().any_sized()) return false;
    BsdfSample sample;
    const float lobe = path.sampler.next();
    if (!bsdf.sample(lobe, path.sampler.next2(), sample) || !real.agrees(sample.direction)) return false;
    path.f *= sample.weight;
    if (path.order == 0) path.first = 1;
    ++path.order;
    path.ray.origin = offset_origin(point, sample.direction);
    return turn(path, sample.direction, sample.pdf, point.position, false);
}

bool PathTracer::meet_boundary(Path& path, const SurfacePoint& point, uint32_t surface) const {
    const ScatteringInterior& interior = *world_.surfaces()[surface].interior;
    const Crossing crossing = world_.cross(point, surface, path.ray.direction, path.nesting);
    if (!path.seen) {
        path.seen = true;
        const vec3 extinction = interior.sigma_s_per_m + interior.sigma_a_per_m;
        for (int c = 0; c < 3; ++c)
            path.result.values.albedo[c] = extinction[c] > 0.0f ? interior.sigma_s_per_m[c] / extinction[c] : 1.0f;
        path.result.values.normal = point.normal;
    }
    const Material& material = *world_.surfaces()[surface].material;
    if (material.paint_cover > 0.0f && !crossing.hidden) {
        const PaintPoint paint = paint_at(material, point);
        if (path.sampler.next() < paint.cover) return meet_paint(path, point, material, paint.colour);
    }
    if (crossing.eta == 1.0f) {
        // shadow rays stop at boundaries that can bend light, so no other strategy finds what lies behind this one
        if (interior.eta != 1.0f) path.specular = true;
        path.nesting = crossing.beyond;
        return pass_straight(path, point, vec3(1.0f));
    }
    if (interior.roughness < kSmoothRoughness) return smooth_boundary(path, point, crossing);
    return rough_boundary(path, point, surface, crossing);
}

bool PathTracer::meet_paint(Path& path, const SurfacePoint& point, const Material& material, const vec3& colour) const {
    MaterialPoint m;
    m.base_colour = colour;
    m.roughness = material.roughness;
    m.f0 = vec3(0.0f);
    m.f90 = 0.0f;
    const bool inside = glm::dot(path.ray.direction, point.geometric_normal) > 0.0f;
    if (!inside) {
        const auto layer =
            physics::standard_material(colour, 0.0f, material.ior, material.specular, material.specular_colour);
        m.f0 = layer.f0;
        m.f90 = layer.f90;
    }
    const vec3 side = inside ? -point.geometric_normal : point.geometric_normal;
    vec3 n = inside ? -point.normal : point.normal;
    if (glm::dot(n, path.ray.direction) >= 0.0f) n = side;
    const StandardBsdf bsdf(m, inside ? nullptr : world_.albedo(), n, -path.ray.direction);
    return scatter_at_surface(path, point, bsdf, side);
}

bool PathTracer::smooth_boundary(Path& path, const SurfacePoint& point, const Crossing& crossing) const {
    const vec3 d = path.ray.direction;
    const bool back = glm::dot(d, point.geometric_normal) > 0.0f;
    const vec3 side = back ? -point.geometric_normal : point.geometric_normal;
    vec3 n = back ? -point.normal : point.normal;
    if (glm::dot(n, d) >= 0.0f) n = side;
    const float choice = path.sampler.next();
    vec3 out;
    for (int attempt = 0; attempt < 2; ++attempt, n = side) {
        const bool reflects = choice < physics::fresnel_dielectric(-glm::dot(n, d), crossing.eta);
        if (reflects)
            out = glm::normalize(d - 2.0f * glm::dot(d, n) * n);
        else if (!physics::refract_ray(d, n, 1.0f / crossing.eta, out))
            continue;
        if ((glm::dot(out, side) > 0.0f) != reflects) continue;  // the interpolated normal bends it to the wrong side
        if (!reflects) {
            path.nesting = crossing.beyond;
            path.f /= crossing.eta * crossing.eta;
            path.bent *= crossing.eta * crossing.eta;
        }
        path.ray.origin = offset_origin(point, out);
        return turn(path, out, 0.0f, point.position, true);
    }
    return false;
}

bool PathTracer::rough_boundary(Path& path, const SurfacePoint& point, uint32_t surface,
                                const Crossing& crossing) const {
    if (path.order + 1 > settings_.max_order) return false;
    const vec3 v = -path.ray.direction;
    const bool back = glm::dot(v, point.geometric_normal) < 0.0f;
    const vec3 side = back ? -point.geometric_normal : point.geometric_normal;
    vec3 n = back ? -point.normal : point.normal;
    if (glm::dot(n, v) <= 0.0f) n = side;
    const RoughBoundary bsdf(n, v, crossing.eta, world_.surfaces()[surface].interior->roughness, path.sampler);
    light_at_surface(path, point, bsdf, crossing.beyond);
    BsdfSample sample;
    if (!bsdf.sample(sample)) return false;
    const bool reflects = glm::dot(sample.direction, n) > 0.0f;
    if ((glm::dot(sample.direction, side) > 0.0f) != reflects) return false;
    if (!reflects) {
        path.nesting = crossing.beyond;
        path.bent *= crossing.eta * crossing.eta;
    }
    path.f *= sample.weight;
    if (path.order == 0) path.first = 1;
    ++path.order;
    path.ray.origin = offset_origin(point, sample.direction);
    return turn(path, sample.direction, sample.pdf, point.position, false);
}

}  // namespace tyndall::reference
