#include "reference/world.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "core/error.h"
#include "core/log.h"

namespace tyndall::reference {
namespace {

using glm::vec3;

bool passes_straight(const Material& material) {
    return material.alpha_mode != AlphaMode::opaque || (material.transmission > 0.0f && material.thickness_m <= 0.0f);
}

RayMask mask_of(const Surface& surface) {
    if (surface.interior) return surface.interior->eta == 1.0f ? RayMask::passing : RayMask::blocking;
    if (passes_straight(*surface.material)) return RayMask::passing;
    return surface.casts_shadow ? RayMask::blocking : RayMask::shadowless;
}

std::vector<RayMask> masks_of(const std::vector<Surface>& surfaces) {
    std::vector<RayMask> masks(surfaces.size());
    std::ranges::transform(surfaces, masks.begin(), mask_of);
    return masks;
}

bool has_layer(const Surface& surface) {
    const Material& material = *surface.material;
    if (surface.interior && !(material.paint_cover > 0.0f)) return false;
    return material.specular > 0.0f || material.metallic > 0.0f;
}

}  // namespace

void Nesting::leave(uint32_t surface) {
    for (size_t i = count_; i-- > 0;)
        if (inside_[i] == surface) {
            std::copy(inside_.begin() + static_cast<std::ptrdiff_t>(i) + 1,
                      inside_.begin() + static_cast<std::ptrdiff_t>(count_),
                      inside_.begin() + static_cast<std::ptrdiff_t>(i));
            --count_;
            return;
        }
}

uint32_t Nesting::current(const std::vector<Surface>& surfaces) const {
    uint32_t best = kNone;
    for (size_t i = 0; i < count_; ++i)
        if (best == kNone || surfaces[inside_[i]].interior->priority > surfaces[best].interior->priority)
            best = inside_[i];
    return best;
}

TracedWorld::TracedWorld(const RenderScene& scene)
    : surfaces_(scene.surfaces),
      masks_(masks_of(surfaces_)),
      camera_(scene.camera),
      geometry_(surfaces_, masks_),
      lights_(scene, geometry_) {
    if (scene.media.size() > MediumPoint::kMost)
        throw Error("the scene has " + std::to_string(scene.media.size()) + " media: at most " +
                    std::to_string(MediumPoint::kMost) + " can be traced");
    const Bounds unit{vec3(-0.5f), vec3(0.5f)};
    for (const Medium& medium : scene.media) {
        const glm::mat4 box = medium_box(medium, scene);
        if (glm::determinant(glm::mat3(box)) == 0.0f) continue;
        const AirOptions options{medium.shape == MediumShape::ellipsoid, medium.temperature, medium.scatter_factor};
        air_.push_back(std::make_unique<MediumVolume>(medium.sigma_s_per_m, medium.sigma_a_per_m,
                                                      medium.emission_cd_m2_per_m, medium.phase, medium.density, box,
                                                      unit, scene.time_s, options));
    }
    if (std::ranges::any_of(scene.media, [](const Medium& medium) { return medium.scatter_factor != 1.0f; }))
        log::warning("a medium has a scatter_factor: what is traced is not physical, as the scene wants it");
    interiors_.resize(surfaces_.size());
    for (size_t i = 0; i < surfaces_.size(); ++i) {
        passing_ = passing_ || masks_[i] == RayMask::passing;
        blocking_ = blocking_ || masks_[i] == RayMask::blocking;
        shadowless_ = shadowless_ || masks_[i] == RayMask::shadowless;
        const auto& interior = surfaces_[i].interior;
        if (!interior ||
            interior->sigma_s_per_m + interior->sigma_a_per_m + interior->emission_cd_m2_per_m == vec3(0.0f))
            continue;
        Bounds local = surfaces_[i].mesh->mesh.bounds;
        const vec3 margin = 1e-3f * local.size() + 1e-6f;  // boundaries are met with rounding
        local = {local.low - margin, local.high + margin};
        interiors_[i] = std::make_unique<MediumVolume>(interior->sigma_s_per_m, interior->sigma_a_per_m,
                                                       interior->emission_cd_m2_per_m, interior->phase,
                                                       interior->density, surfaces_[i].transform, local, scene.time_s);
    }
    if (std::ranges::any_of(surfaces_, has_layer)) albedo_ = std::make_unique<GgxAlbedo>();
    camera_nesting_ = nesting_at(vec3(camera_.transform[3]));
}

Nesting TracedWorld::nesting_at(const vec3& point) const {
    Nesting nesting;
    std::vector<int> balance(surfaces_.size());
    Ray ray{point, glm::normalize(vec3(0.2113f, 0.9511f, -0.1239f))};
    Hit hit;
    for (int i = 0; i < 1000 && geometry_.intersect(ray, RayMask::all, hit); ++i) {
        const SurfacePoint at = geometry_.point(hit);
        balance[hit.surface] += glm::dot(at.geometric_normal, ray.direction) > 0.0f ? 1 : -1;
        ray.origin = offset_origin(at, ray.direction);
    }
    for (uint32_t s = 0; s < surfaces_.size(); ++s)
        if (surfaces_[s].interior && balance[s] > 0) nesting.enter(s);
    return nesting;
}

MediaRay TracedWorld::media(const Ray& ray, float end, const Nesting& nesting) const {
    MediaRay out(ray);
    const uint32_t inside = nesting.current(surfaces_);
    if (inside == Nesting::kNone) {
        for (const auto& medium : air_) out.add(*medium, end);
    } else if (interiors_[inside]) {
        if (interiors_[inside]->homogeneous() && end < std::numeric_limits<float>::infinity())
            out.fill(*interiors_[inside], end);
        else
            out.add(*interiors_[inside], end);  // a ray that found no way out ends at the mesh's bounds
    }
    return out;
}

const MediumVolume* TracedWorld::even_interior(const Nesting& nesting) const {
    const uint32_t inside = nesting.current(surfaces_);
    if (inside == Nesting::kNone || !interiors_[inside]) return nullptr;
    const MediumVolume& medium = *interiors_[inside];
    return medium.homogeneous() && !medium.emits() ? &medium : nullptr;
}

Crossing TracedWorld::cross(const SurfacePoint& point, uint32_t surface, const vec3& direction,
                            const Nesting& nesting) const {
    Crossing crossing{.beyond = nesting};
    if (glm::dot(direction, point.geometric_normal) < 0.0f)
        crossing.beyond.enter(surface);
    else
        crossing.beyond.leave(surface);
    const uint32_t before = nesting.current(surfaces_), after = crossing.beyond.current(surfaces_);
    crossing.hidden = before == after;
    const auto index = [&](uint32_t s) { return s == Nesting::kNone ? 1.0f : surfaces_[s].interior->eta; };
    crossing.eta = index(after) / index(before);
    return crossing;
}

bool TracedWorld::blocked(const Ray& ray, const LightSample& light, float& mis) const {
    if (blocking_ && geometry_.occluded(ray, RayMask::blocking)) return true;
    if (shadowless_ && (!light.placed || mis < 1.0f) && geometry_.occluded(ray, RayMask::shadowless)) {
        if (!light.placed) return true;
        mis = 1.0f;
    }
    return false;
}

vec3 TracedWorld::passed(const Hit& hit, const SurfacePoint& point, const vec3& direction) const {
    const Surface& surface = surfaces_[hit.surface];
    if (!surface.casts_shadow) return vec3(1.0f);
    const MaterialPoint material = material_at(*surface.material, point);
    vec3 through(1.0f - material.opacity);
    if (material.thin_transmission > 0.0f && material.opacity > 0.0f) {
        const vec3 n = glm::dot(material.normal, direction) < 0.0f ? material.normal : -material.normal;
        through += material.opacity * StandardBsdf(material, albedo_.get(), n, -direction).base_transmission();
    }
    return through;
}

vec3 TracedWorld::visibility(const SurfacePoint* leaving, const vec3& place, const LightSample& light, Nesting nesting,
                             float mis, Sampler& sampler) const {
    Ray ray{leaving ? offset_origin(*leaving, light.direction) : place, light.direction, light.distance_m};
    vec3 share(1.0f);
    bool open = false;  // in the air, and nothing blocks the rest of the way
    for (int i = 0; i < 1000; ++i) {
        if (!open && nesting.empty()) {
            if (blocked(ray, light, mis)) return vec3(0.0f);
            open = true;
        }
        const SearchLimit limit = open ? SearchLimit{} : search_limit(nesting, sampler);
        Hit hit;
        Ray leg = ray;
        leg.far_m = std::min(ray.far_m, limit.metres);
        const bool met = (!open || passing_) && geometry_.intersect(leg, open ? RayMask::passing : RayMask::all, hit);
        if (!met && limit.metres < ray.far_m) return vec3(0.0f);
        const float end = met ? hit.distance_m : ray.far_m;
        share *= limit.weight(end);
        const MediaRay media = this->media(ray, end, nesting);
        if (!media.empty()) share *= media.transmittance(end, sampler);
        // a place that rounding put outside of its mesh would be lit as if the mesh were not there
        if (!met) return nesting.empty() || std::isfinite(ray.far_m) ? share * mis : vec3(0.0f);
        const RayMask kind = masks_[hit.surface];
        if (kind == RayMask::blocking || (kind == RayMask::shadowless && !light.placed)) return vec3(0.0f);
        if (kind == RayMask::shadowless) mis = 1.0f;
        const bool boundary = surfaces_[hit.surface].interior.has_value();
        const bool painted = boundary && surfaces_[hit.surface].material->paint_cover > 0.0f;
        const SurfacePoint point = boundary && !painted ? geometry_.flat_point(hit) : geometry_.point(hit);
        if (boundary) {
            const Crossing crossing = cross(point, hit.surface, ray.direction, nesting);
            if (crossing.eta != 1.0f) return vec3(0.0f);
            if (painted && !crossing.hidden) {
                share *= 1.0f - paint_at(*surfaces_[hit.surface].material, point).cover;
                if (share == vec3(0.0f)) return share;
            }
            nesting = crossing.beyond;
        } else if (kind == RayMask::passing) {
            share *= passed(hit, point, ray.direction);
            if (share == vec3(0.0f)) return share;
        }
        ray.origin = offset_origin(point, ray.direction);
        ray.far_m -= hit.distance_m;
    }
    return vec3(0.0f);
}

TracedWorld::SearchLimit TracedWorld::search_limit(const Nesting& nesting, Sampler& sampler) const {
    constexpr float kDepth = 3.0f;
    const MediumVolume* medium = even_interior(nesting);
    if (!medium) return {};
    const float sigma = std::min(medium->sigma_t.x, std::min(medium->sigma_t.y, medium->sigma_t.z));
    if (!(sigma > 0.0f)) return {};
    return {(kDepth - std::log(1.0f - sampler.next_independent())) / sigma, kDepth / sigma, sigma};
}

}  // namespace tyndall::reference
