#pragma once
/// One sample of a pixel: a path from the camera, and all light that it finds.

#include "reference/film.h"
#include "reference/trace.h"
#include "reference/world.h"

namespace tyndall::reference {

/// What one path found.
struct PathResult {
    Film::PixelBatch values;
    uint32_t rays = 0, events = 0;
};

/// Traces paths with next-event estimation; every strategy that can find the same light is weighed against the others
/// (multiple importance sampling, power heuristic).
///
/// Light that a medium of the air scatters once on a path's straight stretch is not looked for where a free flight
/// ends, but at a place drawn for that purpose: by equi-angular sampling toward a light (Kulla & Fajardo 2012) and by
/// the medium's approximate transmittance, as one mixture. Weights against light met by phase sampling depend on the
/// place and direction only, so both ways may draw their places as they like.
///
/// Colour: flights are drawn for one hero channel of a path and weighed by the mean density of all three (Wilkie et
/// al., "Hero Wavelength Spectral Sampling", 2014; Miller et al., "A Null-Scattering Path Integral Formulation", 2019).
class PathTracer {
 public:
    PathTracer(const TracedWorld& world, const TraceSettings& settings);
    /// `stretches` is memory to work in.
    [[nodiscard]] PathResult trace(const Ray& ray, Sampler& sampler, std::vector<MediaRay::Stretch>& stretches) const;

 private:
    struct Path;
    /// The path's next straight stretch and what happens at its end; false when the path is over.
    bool step(Path& path) const;
    bool step_inside(Path& path, const MediumVolume& medium) const;
    void light_along(Path& path, const MediaRay& media) const;
    float draw_distance(Path& path, const MediaRay& media, size_t light, float t0, float t1, float& pdf) const;
    bool scatter_in_medium(Path& path, float t, const MediumPoint& point) const;
    void light_at_medium(Path& path, const glm::vec3& place, const MediumPoint& point) const;
    void meet_lights(Path& path, const MediaRay& media, float end, bool missed) const;
    bool meet_surface(Path& path, const Hit& hit) const;
    bool meet_boundary(Path& path, const SurfacePoint& point, uint32_t surface) const;
    /// A diffuse base under the mirror from outside, a diffuse wall from inside.
    bool meet_paint(Path& path, const SurfacePoint& point, const Material& material, const glm::vec3& colour) const;
    bool scatter_at_surface(Path& path, const SurfacePoint& point, const StandardBsdf& bsdf,
                            const glm::vec3& side) const;
    bool smooth_boundary(Path& path, const SurfacePoint& point, const Crossing& crossing) const;
    bool rough_boundary(Path& path, const SurfacePoint& point, uint32_t surface, const Crossing& crossing) const;
    bool meet_standard(Path& path, const Hit& hit, const SurfacePoint& point) const;
    bool pass_straight(Path& path, const SurfacePoint& point, const glm::vec3& through) const;
    void add_emission(Path& path, const Hit& hit, const SurfacePoint& point) const;
    template <class Bsdf>
    void light_at_surface(Path& path, const SurfacePoint& point, const Bsdf& bsdf, const Nesting& other_side) const;
    bool turn(Path& path, const glm::vec3& direction, float pdf, const glm::vec3& place, bool specular) const;
    bool roulette(Path& path) const;
    void add(Path& path, const glm::vec3& value, int order, int first) const;

    const TracedWorld& world_;
    TraceSettings settings_;
    bool all_positional_ = false;
};

}  // namespace tyndall::reference
