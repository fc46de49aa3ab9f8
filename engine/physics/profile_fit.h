#pragma once
/// Sums of Gaussians for profiles of diffusion.

#include <glm/vec3.hpp>

#include "physics/diffusion_profile.h"
#include "physics/radial_profile.h"

namespace tyndall::physics {

/// A profile as Gaussians, and how far they are off; a channel each.
struct ProfileFit {
    DiffusionProfile profile;
    glm::dvec3 total{0.0};  ///< integral of the profile before it was normalised: its diffuse albedo
    /// Root of the mean square of r (fitted - wanted) along r, over that of r wanted (d'Eon & Luebke 2007, 14.5, have r
    /// inside of the square's integral, which is infinite where a profile goes as 1/r).
    glm::dvec3 error{0.0};
    /// RMS of what is wrong with the edge of a lit half plane where it is between 0.5 % and 99.5 %.
    glm::dvec3 edge_error{0.0};
};

/// Non-negative least squares over `lobes` variances (1 to 16), the same for all channels, in equal steps of their
/// logarithm. The narrowest and the widest are searched for: those that bring the smallest error. What counts is the
/// error weighted by area, and that of an edge.
[[nodiscard]] ProfileFit fit_profile(const RadialProfile& wanted, int lobes = 6);

}  // namespace tyndall::physics
