// Surfaces and boundaries that paths meet.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "physics/physics.h"
#include "reference/path_state.h"
#include "reference/rough_boundary.h"

namespace tyndall::reference {

using glm::vec2;
using glm::vec3;

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
