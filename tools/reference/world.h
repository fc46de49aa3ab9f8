#pragma once
/// A RenderScene made ready for tracing, and the questions that paths ask of it.

#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <vector>

#include "reference/geometry.h"
#include "reference/lights.h"
#include "reference/media.h"
#include "reference/standard_bsdf.h"

namespace tyndall::reference {

/// The closed surfaces with an interior that hold a point, by nested dielectrics' rules (Schmidt & Budge, "Simple
/// Nested Dielectrics in Ray Traced Images", 2002): the one with the highest priority is there, the first of equals.
class Nesting {
 public:
    static constexpr uint32_t kNone = ~0u;

    void enter(uint32_t surface) {
        if (count_ < inside_.size()) inside_[count_++] = surface;
    }
    void leave(uint32_t surface);
    [[nodiscard]] bool empty() const { return count_ == 0; }
    /// The surface whose interior is there, or kNone for air.
    [[nodiscard]] uint32_t current(const std::vector<Surface>& surfaces) const;

 private:
    std::array<uint32_t, 8> inside_{};
    size_t count_ = 0;
};

/// What a boundary does to a ray that meets it.
struct Crossing {
    float eta = 1.0f;     ///< index beyond over index here; 1 = it goes straight on
    bool hidden = false;  ///< the boundary is inside something of higher priority: it is not there
    Nesting beyond;
};

/// See the file's head.
class TracedWorld {
 public:
    /// Copies what it needs; keeps the scene's meshes and textures alive. Throws Error for more media than it can hold.
    explicit TracedWorld(const RenderScene& scene);

    [[nodiscard]] const std::vector<Surface>& surfaces() const { return surfaces_; }
    [[nodiscard]] const Geometry& geometry() const { return geometry_; }
    [[nodiscard]] const Lights& lights() const { return lights_; }
    [[nodiscard]] const GgxAlbedo* albedo() const { return albedo_.get(); }
    [[nodiscard]] const Camera& camera() const { return camera_; }
    [[nodiscard]] const Nesting& camera_nesting() const { return camera_nesting_; }

    /// The media between the ray's start and `end`, where `nesting` holds the start and no boundary is met before.
    [[nodiscard]] MediaRay media(const Ray& ray, float end, const Nesting& nesting) const;
    /// The even, dark medium of the interior that holds a place, or null: flights in it are drawn before the boundary
    /// is looked for.
    [[nodiscard]] const MediumVolume* even_interior(const Nesting& nesting) const;
    [[nodiscard]] Crossing cross(const SurfacePoint& point, uint32_t surface, const glm::vec3& direction,
                                 const Nesting& nesting) const;
    /// Estimate of what share of a light comes through to a place; 0 when something blocks it. `mis` is the sample's
    /// weight beside other strategies: where the light passes a surface that casts no shadow it becomes 1, since paths
    /// cannot follow it there. `leaving`: the surface that the place lies on, or null.
    [[nodiscard]] glm::vec3 visibility(const SurfacePoint* leaving, const glm::vec3& place, const LightSample& light,
                                       Nesting nesting, float mis, Sampler& sampler) const;

 private:
    /// How far a shadow ray inside a dense interior looks for the way out. Few lengths are traced beyond three mean
    /// free paths, and count for the others: little light comes from there.
    struct SearchLimit {
        float metres = std::numeric_limits<float>::infinity();
        float certain_m = std::numeric_limits<float>::infinity();  ///< up to here every ray looks
        float sigma = 0.0f;
        /// One over the probability of looking as far as this.
        [[nodiscard]] float weight(float at) const {
            return at <= certain_m ? 1.0f : std::exp(sigma * (at - certain_m));
        }
    };
    [[nodiscard]] SearchLimit search_limit(const Nesting& nesting, Sampler& sampler) const;
    [[nodiscard]] bool blocked(const Ray& ray, const LightSample& light, float& mis) const;
    [[nodiscard]] glm::vec3 passed(const Hit& hit, const SurfacePoint& point, const glm::vec3& direction) const;
    [[nodiscard]] Nesting nesting_at(const glm::vec3& point) const;

    std::vector<Surface> surfaces_;
    std::vector<RayMask> masks_;
    Camera camera_;
    Geometry geometry_;
    Lights lights_;
    std::unique_ptr<GgxAlbedo> albedo_;
    std::vector<std::unique_ptr<MediumVolume>> air_;
    std::vector<std::unique_ptr<MediumVolume>> interiors_;  ///< by surface; null = clear or none
    bool passing_ = false, blocking_ = false, shadowless_ = false;
    Nesting camera_nesting_;
};

}  // namespace tyndall::reference
