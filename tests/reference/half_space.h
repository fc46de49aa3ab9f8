#pragma once
/// How much light a half-space of a scattering material returns.

#include <glm/vec3.hpp>

#include "scenes.h"

namespace tyndall::reference {

/// Share of collimated light, coming at `angle_deg` to the normal, that enters a half-space and comes out again, for
/// three albedos at once. Isotropic phase function, smooth boundary of relative index `eta`; light mirrored by the
/// boundary does not count.
///
/// By reciprocity this is the radiance seen at that angle in a uniform field of radiance 1. So the camera looks at the
/// face of a box, 4000 mean free paths deep and wide, and every path counts: no exitant flux has to be collected.
/// Passing a smooth boundary does not count as scattering, so what the boundary mirrors has order 0, and leaving order
/// 0 out is exact. All channels have an extinction of 1, so they share every flight.
[[nodiscard]] Measured half_space_reflectance(const glm::vec3& albedo, float eta, float angle_deg, int pixels,
                                              int64_t samples);

/// The same without a boundary by Chandrasekhar's H function (Radiative Transfer, 1960, par. 33 and 38): 1 - H(mu)
/// sqrt(1 - albedo). Its integral equation is solved by iteration.
[[nodiscard]] double chandrasekhar_reflectance(double albedo, double cosine);

}  // namespace tyndall::reference
