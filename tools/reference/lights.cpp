#include "reference/lights.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "physics/physics.h"
#include "reference/textures.h"
#include "scene/environment.h"
#include "scene/texture_lookup.h"

namespace tyndall::reference {
namespace {

using glm::vec2;
using glm::vec3;

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr float kWidestCone = 0.0872f;  ///< cosine: rays are not clipped to wider cones

float luminance(const vec3& v) {
    return physics::luminance_rec709(v);
}

vec3 travel(const Light& light) {
    return -vec3(light.transform[2]);
}

/// As render/shaders/lights.glsl has it.
vec3 gobo_toward(const Light& light, const vec3& point) {
    if (!light.gobo) return vec3(1.0f);
    const vec3 offset = point - vec3(light.transform[3]);
    vec2 half = 0.5f * light.gobo_size_m;
    if (light.kind == LightKind::spot)
        half = vec2(std::tan(light.outer_angle) * std::max(glm::dot(offset, travel(light)), 1e-6f));
    const vec2 at(glm::dot(offset, vec3(light.transform[0])), -glm::dot(offset, vec3(light.transform[1])));
    const glm::vec4 value =
        sample_texture(*light.gobo, 0.5f + 0.5f * at / half, TextureWrap::clamp, TextureWrap::clamp);
    return glm::clamp(light.gobo->image.channels < 3 ? vec3(value.x) : vec3(value), 0.0f, 1.0f);
}

}  // namespace

Lights::Lights(const RenderScene& scene, const Geometry& geometry) : geometry_(geometry), surfaces_(scene.surfaces) {
    for (const Light& light : scene.lights) {
        if (light.of_environment) continue;  // its image is met itself
        Entry entry;
        entry.light = light;
        entry.kind = light.kind == LightKind::directional ? Kind::directional : Kind::placed;
        entry.strength = luminance(light.intensity);
        if (entry.strength <= 0.0f) continue;
        if (light.kind == LightKind::spot) {
            entry.cos_inner = std::cos(light.inner_angle);
            entry.cos_outer = std::cos(light.outer_angle);
        }
        if (light.kind == LightKind::directional) entry.cos_radius = std::cos(light.angular_radius);
        entries_.push_back(std::move(entry));
    }
    sky_ = Environment(scene.sky.image, scene.sky.radiance, scene.sky.rotation);
    const tyndall::Environment around = environment_of(scene);
    environment_ = Environment(around.image, around.radiance, around.world_from_image);
    if (!environment_.dark())
        entries_.push_back({.kind = Kind::environment, .strength = environment_.mean_luminance()});
    triangles_light_ = entries_.size();
    add_triangles(scene);
    for (size_t i = 0; i < entries_.size(); ++i) any_sized_ = any_sized_ || sized(i);
}

void Lights::add_triangles(const RenderScene& scene) {
    triangle_power_.resize(scene.surfaces.size());
    double sum = 0.0;
    for (size_t s = 0; s < scene.surfaces.size(); ++s) {
        const Surface& surface = scene.surfaces[s];
        const float radiance = luminance(surface.material->emissive);
        if (radiance <= 0.0f) continue;
        const size_t count = surface.mesh->mesh.triangle_count();
        triangle_power_[s].resize(count);
        for (uint32_t t = 0; t < count; ++t) {
            const float area = geometry_.area(static_cast<uint32_t>(s), t);
            if (!(area > 0.0f)) continue;
            triangle_power_[s][t] = radiance * area;
            sum += static_cast<double>(radiance * area);
            triangles_.push_back({static_cast<uint32_t>(s), t, area, radiance * area});
            triangle_sums_.push_back(static_cast<float>(sum));
            for (const vec2 corner : {vec2(0, 0), vec2(1, 0), vec2(0, 1)})
                triangle_bounds_.add(geometry_.point_on(static_cast<uint32_t>(s), t, corner).position);
        }
    }
    if (!triangles_.empty()) entries_.push_back({.kind = Kind::triangles, .strength = static_cast<float>(sum)});
}

bool Lights::positional(size_t light) const {
    return entries_[light].kind == Kind::placed;
}

bool Lights::sized(size_t light) const {
    const Entry& entry = entries_[light];
    if (entry.kind == Kind::placed) return entry.light.source_radius_m > 0.0f;
    return entry.kind != Kind::directional || entry.light.angular_radius > 0.0f;
}

vec3 Lights::position(size_t light) const {
    return vec3(entries_[light].light.transform[3]);
}

float Lights::weight_at(size_t light, const vec3& point) const {
    const Entry& entry = entries_[light];
    switch (entry.kind) {
        case Kind::directional:
            return entry.strength;
        case Kind::environment:
            return entry.strength * physics::kPi;
        case Kind::triangles: {
            const vec3 away =
                glm::max(glm::max(triangle_bounds_.low - point, point - triangle_bounds_.high), vec3(0.0f));
            const float size = triangle_bounds_.radius();
            return entry.strength / (glm::dot(away, away) + size * size);
        }
        case Kind::placed:
            break;
    }
    const vec3 offset = vec3(entry.light.transform[3]) - point;
    const float square = std::max(glm::dot(offset, offset), 1e-12f), metres = std::sqrt(square);
    float share = physics::range_window(metres, entry.light.range_m) / square;
    if (entry.light.kind == LightKind::spot && !sized(light))
        share *=
            physics::spot_falloff(static_cast<int>(entry.light.profile),
                                  -glm::dot(offset, travel(entry.light)) / metres, entry.cos_inner, entry.cos_outer);
    return entry.strength * share;
}

float Lights::weight_along(size_t light, const Ray& ray, float& t0, float& t1) const {
    const Entry& entry = entries_[light];
    if (entry.kind != Kind::placed) return t0 < t1 ? weight_at(light, ray.origin) * (t1 - t0) : 0.0f;
    const vec3 centre(entry.light.transform[3]);
    if (entry.light.range_m > 0.0f &&
        !physics::clip_to_sphere(ray.origin, ray.direction, centre, entry.light.range_m, t0, t1))
        return 0.0f;
    const bool narrow = entry.light.kind == LightKind::spot && entry.cos_outer > kWidestCone && !sized(light);
    if (narrow && !physics::clip_to_infinite_cone(ray.origin, ray.direction, centre, travel(entry.light),
                                                  entry.cos_outer, t0, t1))
        return 0.0f;
    if (!(t0 < t1)) return 0.0f;
    const vec3 offset = centre - ray.origin;
    const float foot = glm::dot(offset, ray.direction);
    const float d = std::max(glm::length(offset - foot * ray.direction), 1e-6f);
    return entry.strength * (std::atan((t1 - foot) / d) - std::atan((t0 - foot) / d)) / d;
}

float Lights::probability_at(size_t light, const vec3& point) const {
    float sum = 0.0f;
    for (size_t i = 0; i < entries_.size(); ++i) sum += weight_at(i, point);
    return sum > 0.0f ? weight_at(light, point) / sum : 0.0f;
}

bool Lights::choose_at(float xi, const vec3& point, size_t& light, float& probability) const {
    if (entries_.size() == 1) {
        light = 0, probability = 1.0f;
        return weight_at(0, point) > 0.0f;
    }
    float sum = 0.0f;
    for (size_t i = 0; i < entries_.size(); ++i) sum += weight_at(i, point);
    if (!(sum > 0.0f)) return false;
    float left = xi * sum;
    for (size_t i = 0; i < entries_.size(); ++i) {
        const float weight = weight_at(i, point);
        if (weight <= 0.0f) continue;
        light = i, probability = weight / sum;
        left -= weight;
        if (left < 0.0f) break;
    }
    return true;
}

vec3 Lights::intensity_toward(const Entry& entry, const vec3& point, const vec3& to_light, float metres) const {
    float share = physics::range_window(metres, entry.light.range_m);
    if (entry.light.kind == LightKind::spot)
        share *= physics::spot_falloff(static_cast<int>(entry.light.profile), -glm::dot(to_light, travel(entry.light)),
                                       entry.cos_inner, entry.cos_outer);
    if (share <= 0.0f) return vec3(0.0f);
    return entry.light.intensity * gobo_toward(entry.light, point) * share;
}

bool Lights::sample_placed(const Entry& entry, const vec3& point, vec2 xi, LightSample& out) const {
    const vec3 offset = vec3(entry.light.transform[3]) - point;
    const float square = glm::dot(offset, offset), metres = std::sqrt(square), radius = entry.light.source_radius_m;
    if (!(square > 0.0f)) return false;
    const vec3 axis = offset / metres;
    if (radius <= 0.0f) {
        out = {axis, metres, intensity_toward(entry, point, axis, metres) / square};
        return out.light != vec3(0.0f);
    }
    if (metres <= radius) return false;  // inside the source there is no light of it
    // the cone that the sphere fills; 1 - cos without cancellation
    const float sine2 = radius * radius / square, less = sine2 / (1.0f + std::sqrt(1.0f - sine2));
    const float cosine = 1.0f - xi.x * less;
    out.direction = physics::direction_about(axis, cosine, xi.y);
    const float hit = metres * cosine - std::sqrt(std::max(0.0f, radius * radius - square * (1.0f - cosine * cosine)));
    out.distance_m = std::max(hit, 0.0f);
    out.pdf = 1.0f / (physics::kTwoPi * less);
    out.light = intensity_toward(entry, point, out.direction, metres) / (physics::kPi * radius * radius * out.pdf);
    return out.light != vec3(0.0f);
}

bool Lights::sample_directional(const Entry& entry, const vec3& point, vec2 xi, LightSample& out) const {
    const vec3 axis = -travel(entry.light);
    const vec3 illuminance = entry.light.intensity * gobo_toward(entry.light, point);
    if (entry.light.angular_radius <= 0.0f) {
        out = {axis, kInfinity, illuminance};
        return true;
    }
    const float sine = std::sin(entry.light.angular_radius), less = sine * sine / (1.0f + entry.cos_radius);
    out.direction = physics::direction_about(axis, 1.0f - xi.x * less, xi.y);
    out.distance_m = kInfinity;
    out.pdf = 1.0f / (physics::kTwoPi * less);
    out.light = illuminance / (physics::kPi * sine * sine * out.pdf);
    return true;
}

bool Lights::sample_triangles(const vec3& point, vec2 xi, LightSample& out) const {
    const float wanted = xi.x * triangle_sums_.back();
    const auto chosen =
        std::min<size_t>(static_cast<size_t>(std::upper_bound(triangle_sums_.begin(), triangle_sums_.end(), wanted) -
                                             triangle_sums_.begin()),
                         triangles_.size() - 1);
    const Triangle& triangle = triangles_[chosen];
    const float low = chosen > 0 ? triangle_sums_[chosen - 1] : 0.0f;
    const float again = std::clamp((wanted - low) / std::max(triangle_sums_[chosen] - low, 1e-30f), 0.0f, 0.99999994f);
    const float root = std::sqrt(again);
    const vec2 barycentric(xi.y * root, 1.0f - root);
    const SurfacePoint on = geometry_.point_on(triangle.surface, triangle.triangle, barycentric);
    const vec3 offset = on.position - point;
    const float square = glm::dot(offset, offset);
    if (!(square > 0.0f)) return false;
    out.distance_m = std::sqrt(square);
    out.direction = offset / out.distance_m;
    const float cosine = std::abs(glm::dot(on.geometric_normal, out.direction));
    if (!(cosine > 0.0f)) return false;
    out.pdf = triangle.power / triangle_sums_.back() / triangle.area * square / cosine;
    out.light = emitted(triangle.surface, on, -out.direction) / out.pdf;
    out.distance_m *= 0.9999f;  // the triangle itself is not in the way
    return out.light != vec3(0.0f);
}

bool Lights::sample(size_t light, const vec3& point, vec2 xi, LightSample& out) const {
    const Entry& entry = entries_[light];
    out.placed = entry.kind == Kind::placed || entry.kind == Kind::directional;
    switch (entry.kind) {
        case Kind::placed:
            return sample_placed(entry, point, xi, out);
        case Kind::directional:
            return sample_directional(entry, point, xi, out);
        case Kind::triangles:
            return sample_triangles(point, xi, out);
        case Kind::environment:
            break;
    }
    out.direction = environment_.sample(xi, out.pdf);
    out.distance_m = kInfinity;
    out.light = environment_.radiance(out.direction) / out.pdf;
    return out.pdf > 0.0f;
}

bool Lights::meets(size_t light, const Ray& ray, bool missed, vec3& radiance, float& pdf, float& metres) const {
    const Entry& entry = entries_[light];
    metres = kInfinity;
    if (entry.kind == Kind::environment) {
        if (!missed) return false;
        radiance = environment_.radiance(ray.direction);
        pdf = environment_.pdf(ray.direction);
        return true;
    }
    if (entry.kind == Kind::triangles || !sized(light)) return false;
    if (entry.kind == Kind::directional) {
        // by the sine: the cosine of a small sun would be rounded
        const vec3 axis = -travel(entry.light), aside = ray.direction - axis * glm::dot(axis, ray.direction);
        const float limit = std::sin(entry.light.angular_radius);
        if (!missed || glm::dot(axis, ray.direction) <= 0.0f || glm::dot(aside, aside) > limit * limit) return false;
        const float sine = std::sin(entry.light.angular_radius), less = sine * sine / (1.0f + entry.cos_radius);
        radiance = entry.light.intensity * gobo_toward(entry.light, ray.origin) / (physics::kPi * sine * sine);
        pdf = 1.0f / (physics::kTwoPi * less);
        return true;
    }
    const float radius = entry.light.source_radius_m;
    const vec3 offset = vec3(entry.light.transform[3]) - ray.origin;
    const float square = glm::dot(offset, offset);
    if (square <= radius * radius) return false;
    const float foot = glm::dot(offset, ray.direction);
    const vec3 aside = offset - foot * ray.direction;
    const float chord = radius * radius - glm::dot(aside, aside);
    if (foot <= 0.0f || chord < 0.0f) return false;
    metres = foot - std::sqrt(chord);
    if (metres > ray.far_m) return false;
    const float sine2 = radius * radius / square, less = sine2 / (1.0f + std::sqrt(1.0f - sine2));
    radiance = intensity_toward(entry, ray.origin, ray.direction, std::sqrt(square)) / (physics::kPi * radius * radius);
    pdf = 1.0f / (physics::kTwoPi * less);
    return true;
}

float Lights::triangle_pdf(const Hit& hit, const SurfacePoint& point, const vec3& from) const {
    const std::vector<float>& powers = triangle_power_[hit.surface];
    if (powers.empty()) return 0.0f;
    const vec3 offset = point.position - from;
    const float square = glm::dot(offset, offset);
    const float cosine = std::abs(glm::dot(point.geometric_normal, offset)) / std::sqrt(square);
    const float area = geometry_.area(hit.surface, hit.triangle);
    if (!(cosine > 0.0f) || !(area > 0.0f)) return 0.0f;
    return powers[hit.triangle] / triangle_sums_.back() / area * square / cosine;
}

vec3 Lights::emitted(uint32_t surface, const SurfacePoint& point, const vec3& direction) const {
    const Material& material = *surfaces_[surface].material;
    if (material.emissive == vec3(0.0f)) return vec3(0.0f);
    if (!material.double_sided && glm::dot(direction, point.geometric_normal) <= 0.0f) return vec3(0.0f);
    return material.emissive * vec3(sample_slot(material.emissive_texture, point));
}

}  // namespace tyndall::reference
