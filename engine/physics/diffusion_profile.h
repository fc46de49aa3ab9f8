#pragma once
/// How light that enters a flat, thick piece of skin (or wax, or milk) at one place is spread over the surface where it
/// leaves.

#include <glm/vec3.hpp>
#include <vector>

namespace tyndall::physics {

/// One Gaussian e^(-r^2 / 2 v) / (2 pi v) over the plane, whose integral is 1.
struct DiffusionLobe {
    float variance_m2 = 0.0f;  ///< v; above 0
    glm::vec3 weight{0.0f};
    bool operator==(const DiffusionLobe&) const = default;
};

/// A radial profile as a sum of Gaussians (d'Eon & Luebke, GPU Gems 3, 2007, 14.5), a weight per channel each. The
/// weights of a channel sum to 1: what is absorbed is in the surface's albedo. Narrowest lobe first.
struct DiffusionProfile {
    std::vector<DiffusionLobe> lobes;
    bool operator==(const DiffusionProfile&) const = default;

    /// Share of the light that leaves in a unit of area, `r` metres from where it entered; 1/m2.
    [[nodiscard]] glm::vec3 at(float r) const;
    /// Integral of `at` along a line, `x` metres from a point: how a thin slit of light is seen; 1/m.
    [[nodiscard]] glm::vec3 line(float x) const;
    /// Share of the light that leaves `x` metres inside of the straight edge of a lit half plane; 0..1.
    [[nodiscard]] glm::vec3 edge(float x) const;
    /// Share of light that leaves nearer than `r` metres.
    [[nodiscard]] glm::vec3 within(float r) const;
    /// What comes through `s` metres of it, over the light that enters the other side: each lobe as e^(-s^2 / v)
    /// (Jimenez et al., Real-Time Realistic Skin Translucency, 2010, eq. 8, as formulas of the source have it).
    [[nodiscard]] glm::vec3 through(float s) const;
    /// The mean of r^2 over the profile, a channel each; m2.
    [[nodiscard]] glm::vec3 mean_square() const;
    /// Every distance times `factor`.
    [[nodiscard]] DiffusionProfile scaled(float factor) const;
    /// Weights of each channel sum to 1, lobes of one variance are one and the narrowest comes first.
    void normalise();
};

/// Skin of three layers as d'Eon & Luebke fitted it to Donner & Jensen's (GPU Gems 3, figure 14-13).
[[nodiscard]] DiffusionProfile six_gaussian_skin();

}  // namespace tyndall::physics
