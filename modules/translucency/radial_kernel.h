#pragma once
/// A model of diffusion as a table over the distance.

#include <array>
#include <cstdint>
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
    bool operator==(const Optics&) const = default;
    [[nodiscard]] glm::vec3 albedo() const;
};
[[nodiscard]] Optics optics_of(const ScatteringInterior& interior);

/// Exitance per entered flux of a model at `r` metres, 1/m2, as published. The directional dipole for light along the
/// normal.
[[nodiscard]] glm::vec3 exitance(Model model, const Optics& optics, float r);

/// The exitance of a small piece of surface through which a unit of flux enters, by the distance from its middle, 1/m2:
/// the mean of the model over a disc of the piece's size. Linear between entries at r^2 = 2^(low + i / 16).
class RadialKernel {
 public:
    static constexpr int kOctaves = 26, kPerOctave = 16;  ///< of the squared distance
    static constexpr int kEntries = kOctaves * kPerOctave;

    /// `piece_radius` in metres. `scaling` exact makes the integral over the plane 1.
    RadialKernel(const Optics& optics, Model model, Scaling scaling, float piece_radius);

    /// rgb; a: luminance of the part that comes up from deep inside.
    [[nodiscard]] const std::vector<glm::vec4>& table() const { return table_; }
    /// The bits of the float at which the table begins.
    [[nodiscard]] uint32_t low_bits() const { return low_bits_; }
    [[nodiscard]] glm::vec3 at(float r) const;
    /// Share of the light that leaves within one piece's radius of where it entered.
    [[nodiscard]] const glm::vec3& own() const { return own_; }
    /// Integral of the model over the plane, before scaling.
    [[nodiscard]] const glm::vec3& returned() const { return returned_; }

 private:
    static constexpr int kSteps = 640;  ///< of the integral over the distance

    void integrate(const Optics& optics, Model model);
    [[nodiscard]] glm::dvec3 within(double r) const;
    [[nodiscard]] glm::dvec3 mean_over_disc(double r, double radius) const;

    double first_ = 0.0, step_ = 0.0;   ///< log of the distances of `within_`
    std::vector<glm::dvec3> within_;    ///< share that leaves nearer than that
    std::vector<glm::vec4> table_;
    uint32_t low_bits_ = 0;
    glm::vec3 own_{0.0f};
    glm::vec3 returned_{0.0f};
};

}  // namespace tyndall::translucency
