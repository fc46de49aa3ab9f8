#pragma once
/// Profiles of skin that are measured or follow from coefficients.

#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "physics/multipole.h"
#include "physics/profile_fit.h"

namespace tyndall::physics {

/// A profile as Gaussians, what it was fitted to, and what belongs to it.
struct SolidProfile {
    ProfileFit fit;
    RadialProfile exact;
    /// Of diffuse light that has entered, what leaves: of a solid without end exactly (HalfSpace), of layers what
    /// layered_response has for light along the normal.
    glm::dvec3 albedo{0.0};
    std::vector<SolidLayer> layers;  ///< none where the profile is not one of a solid
};

/// The layers' exitance (solid_exitance), fitted.
[[nodiscard]] SolidProfile solid_profile(const std::vector<SolidLayer>& layers, int lobes = 6);
/// Christensen & Burley 2015 (normalised_diffusion): `albedo` is all that leaves, `mean_free_path_m` along a flight.
[[nodiscard]] SolidProfile burley_profile(const glm::vec3& albedo, const glm::vec3& mean_free_path_m, int lobes = 6);

/// Jensen et al. 2001, A Practical Model for Subsurface Light Transport, figure 5: index 1.3, without end.
[[nodiscard]] SolidLayer jensen_skin1();
[[nodiscard]] SolidLayer jensen_skin2();
/// Epidermis, upper dermis and bloody dermis as of Donner & Jensen 2005 (coefficients in 1/cm there), index 1.4.
[[nodiscard]] std::vector<SolidLayer> three_layer_skin();

}  // namespace tyndall::physics
