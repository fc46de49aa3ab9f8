#pragma once
/// Light that diffuses through layers: the multipole (Donner & Jensen 2005, Light Diffusion in Multi-Layered
/// Translucent Materials), by the spatial frequency over the surface, where sums of images and the layers' exchange
/// have closed forms.

#include <glm/vec3.hpp>
#include <limits>
#include <span>

namespace tyndall::physics {

/// A layer of a solid, a channel each; scattering reduced, as if isotropic.
struct SolidLayer {
    double thickness_m = std::numeric_limits<double>::infinity();
    glm::dvec3 sigma_a{0.0};          ///< 1/m
    glm::dvec3 sigma_s_reduced{0.0};  ///< 1/m; above 0
    double eta = 1.4;                 ///< index of refraction against the outside; 1..2
    bool operator==(const SolidLayer&) const = default;
};

/// A = (1 + Fdr) / (1 - Fdr) of a boundary: `eta` = n_here / n_beyond.
[[nodiscard]] double boundary_parameter(double eta);

/// Of light that has entered along the normal, what leaves on the side where it entered and on the other: transforms of
/// the radial profiles (FrequencyFunction); at frequency 0 their totals.
struct SolidResponse {
    glm::dvec3 reflected{0.0}, transmitted{0.0};
};

/// As published: each layer alone by images of one source at a depth of a mean free path, lit from above and from
/// below, then all that goes to and fro between them (Kubelka-Munk). `layers` from the top down, at least one; `k` in
/// 1/m. In a layer that is thinner than two mean free paths, its source lies in its middle: there the method returns
/// too much, up to three times at half a mean free path (see layered_response, which does not).
[[nodiscard]] SolidResponse multipole_response(std::span<const SolidLayer> layers, double k);

}  // namespace tyndall::physics
