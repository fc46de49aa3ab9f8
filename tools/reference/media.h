#pragma once
/// Media along a ray: free flights, transmittance, and where it pays to look for light.

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <memory>
#include <optional>
#include <vector>

#include "reference/geometry.h"
#include "reference/phase.h"
#include "reference/sampler.h"
#include "scene/density.h"
#include "scene/render_scene.h"

namespace tyndall::reference {

/// What only media of the air have.
struct AirOptions {
    bool ellipsoid = false;  ///< it fills the largest ellipsoid of the box only
    std::optional<TemperatureField> temperature;
    float scatter_factor = 1.0f;  ///< multiplies what is scattered and not what is lost
};

/// One medium in a box of its local space: of the air, or inside a mesh.
class MediumVolume {
 public:
    /// `local` holds every place where it may be. Coefficients are 1/m.
    MediumVolume(glm::vec3 sigma_s, glm::vec3 sigma_a, glm::vec3 emission, const PhaseFunction& phase,
                 const DensityField& density, const glm::mat4& local_to_world, const Bounds& local, double time_s,
                 const AirOptions& options = {});

    glm::vec3 sigma_s;  ///< of the light that is scattered: times the scatter factor
    glm::vec3 sigma_a, sigma_t, emission;
    Phase phase;
    [[nodiscard]] bool homogeneous() const { return density_.constant(); }
    [[nodiscard]] bool emits() const { return emits_; }
    [[nodiscard]] float density(const glm::vec3& world) const {
        return density_.constant() ? 1.0f : density_.at(glm::vec3(to_local_ * glm::vec4(world, 1.0f)));
    }
    /// Radiance given off per metre where the density is `density`.
    [[nodiscard]] glm::vec3 emission_at(const glm::vec3& world, float density) const;
    /// The part of a ray inside the box, or the ellipsoid.
    [[nodiscard]] bool clip(const Ray& ray, float& t0, float& t1) const;

 private:
    friend class MediaRay;
    static constexpr int kCells = 32;  ///< of the majorant grid, along each axis
    struct Cell {
        float most = 0.0f;  ///< no density is above this
        float mean = 0.0f;  ///< about
    };
    DensityEvaluator density_;
    glm::mat4 to_local_;
    Bounds local_;
    bool emits_ = false;
    bool ellipsoid_ = false;
    std::optional<GridEvaluator> temperature_;
    float base_k_ = 0.0f;
    std::vector<Cell> cells_;
};

/// What scatters at a place: the sums over overlapping media.
struct MediumPoint {
    static constexpr size_t kMost = 16;
    glm::vec3 sigma_s{0.0f}, sigma_t{0.0f}, emission{0.0f};
    struct Part {
        const MediumVolume* medium = nullptr;
        float density = 0.0f;
    } parts[kMost];
    size_t count = 0;

    /// Sum of sigma_s p(u), per channel.
    [[nodiscard]] glm::vec3 scattering(float u) const;
    /// Density of the directions that `sample` draws.
    [[nodiscard]] float pdf(float u) const;
    /// A cosine, and what the path is multiplied by, to be divided by sigma_t elsewhere: sum of sigma_s over the share.
    [[nodiscard]] float sample(Sampler& sampler, glm::vec3& scattering_over_pdf) const;
};

/// The media that a ray crosses.
class MediaRay {
 public:
    /// A stretch of the ray with nearly even media.
    struct Stretch {
        float from = 0.0f, to = 0.0f;
        float sigma = 0.0f;          ///< about the extinction, mean of the channels
        float transmittance = 1.0f;  ///< about, from the ray's start to `from`
        [[nodiscard]] float length() const { return to - from; }
        /// What of the light that began at the ray's start is lost here.
        [[nodiscard]] float mass() const;
        /// Where `lost` of it is lost, 0 to mass().
        [[nodiscard]] float place_of(float lost) const;
    };

    explicit MediaRay(const Ray& ray) : ray_(ray) {}
    /// Adds what of `medium` lies between 0 and `end`.
    void add(const MediumVolume& medium, float end);
    /// Adds an even medium that fills the ray up to `end`.
    void fill(const MediumVolume& medium, float end) { spans_[count_++] = {&medium, 0.0f, end}; }
    [[nodiscard]] bool empty() const { return count_ == 0; }
    [[nodiscard]] bool emits() const;
    /// From where to where there may be a medium.
    void extent(float& t0, float& t1) const;

    /// Unbiased estimate of the transmittance from the start to `end`; exact for homogeneous media.
    [[nodiscard]] glm::vec3 transmittance(float end, Sampler& sampler) const;
    /// The even stretches between `begin` and `end` that hold a medium.
    void stretches(float begin, float end, std::vector<Stretch>& out) const;
    [[nodiscard]] MediumPoint at(float t) const;

    /// One flight by delta tracking with spectral bookkeeping: `f` is the path's contribution over the density of the
    /// hero channel, `ratio` each channel's density over the hero's. Returns true for a collision at `t` (f then holds
    /// the transmittance over the density, not yet sigma_s), false when `end` was reached. What glows on the way is
    /// added to `glow`, already divided by the mean ratio.
    bool fly(float end, int hero, Sampler& sampler, glm::vec3& f, glm::vec3& ratio, float& t, MediumPoint& point,
             glm::vec3& glow) const;

 private:
    struct Span {
        const MediumVolume* medium = nullptr;
        float t0 = 0.0f, t1 = 0.0f;
        glm::vec3 origin{0.0f}, direction{0.0f};  ///< of the ray over the grid, in cells
    };
    /// Where a walk is within a span's grid (Amanatides & Woo, "A Fast Voxel Traversal Algorithm", 1987).
    struct Steps {
        MediumVolume::Cell cell;            ///< {0, 0} outside of the span
        float until = 0.0f;                 ///< it holds up to here
        int at = -1, stride[3] = {};        ///< index into the cells; -1 before the span was entered
        int left[3] = {};                   ///< cells before the grid ends, along each axis
        float next[3] = {}, delta[3] = {};  ///< where the next face of each axis is, and from one to the next
    };
    static void enter(const Span& span, float t, Steps& steps);
    static void advance(const Span& span, float t, Steps& steps);
    /// Walks through all stretches in [0, end] in order. `visit(from, to, steps)`, steps for each span, returns false
    /// to stop.
    template <class F>
    void walk(float end, F visit) const;

    Ray ray_;
    Span spans_[MediumPoint::kMost];
    size_t count_ = 0;
};

}  // namespace tyndall::reference
