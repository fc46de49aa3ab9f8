#pragma once
/// A model of diffusion as a table over the distance.

#include <array>
#include <functional>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <vector>

#include "physics/half_space.h"
#include "scene/scattering_components.h"
#include "translucency_settings.h"

namespace tyndall::translucency {

/// The reduced optics of an interior, a channel each.
struct Optics {
    glm::vec3 sigma_s_reduced{0.0f};  ///< 1/m
    glm::vec3 sigma_a{0.0f};          ///< 1/m
    float eta = 1.3f;
    float roughness = 0.0f;  ///< of the boundary
    bool operator==(const Optics&) const = default;
    [[nodiscard]] glm::vec3 albedo() const;
};
[[nodiscard]] Optics optics_of(const ScatteringInterior& interior);

/// Exitance per entered flux of a model at `r` metres, 1/m2, as published. The directional dipole for light along the
/// normal.
[[nodiscard]] glm::vec3 exitance(Model model, const Optics& optics, float r);

/// Of light that has entered at a cosine 0..1 to the normal, inside, the share that the directional dipole returns from
/// a half-space, as published.
[[nodiscard]] glm::vec3 directional_returned(const Optics& optics, float cosine);

/// The exitance of a small piece of surface through which a unit of flux enters, by the distance from its middle, 1/m2:
/// the mean of the model over a disc of the piece's size, as a sum of Gaussians w exp(-rate r^2), each rate half of the
/// one before (as d'Eon & Luebke 2007 have profiles of skin): one exponential and products give them all.
class RadialKernel {
 public:
    static constexpr int kGaussians = 16;

    /// `piece_radius` in metres. `scaling` exact makes the integral over the plane 1.
    RadialKernel(const Optics& optics, Model model, Scaling scaling, float piece_radius);

    /// rgb weights, 1/m2, narrowest first.
    [[nodiscard]] const std::array<glm::vec4, kGaussians>& weights() const { return weights_; }
    /// Of the widest, 1/m2.
    [[nodiscard]] float rate() const { return rate_; }
    [[nodiscard]] glm::vec3 at(float r) const;
    /// What the Gaussians are fitted to: the mean over the disc whose middle is `r` metres away.
    [[nodiscard]] glm::vec3 exact(float r) const;
    /// Share of what leaves that does so nearer than `r` metres (of a point, whatever the piece).
    [[nodiscard]] glm::vec3 share_within(float r) const { return glm::vec3(within(double(r)) / within_.back()); }
    /// Integral of the model over the plane, before scaling.
    [[nodiscard]] const glm::vec3& returned() const { return returned_; }

 private:
    static constexpr int kSteps = 640;  ///< of the integral over the distance

    void integrate(const Optics& optics, Model model);
    [[nodiscard]] glm::dvec3 within(double r) const;
    void fit();

    double first_ = 0.0, step_ = 0.0;  ///< log of the distances of `within_`
    std::vector<glm::dvec3> within_;   ///< share that leaves nearer than that
    double piece_radius_ = 0.0;
    std::function<glm::vec3(float)> far_;  ///< the model where the piece is as good as a point
    std::array<glm::vec4, kGaussians> weights_{};
    float rate_ = 0.0f;
    glm::vec3 returned_{0.0f};
};

}  // namespace tyndall::translucency
