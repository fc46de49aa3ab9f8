#pragma once
/// From what a solid does to a pattern of light of one spatial frequency to its radial profile.

#include <functional>
#include <glm/vec3.hpp>

namespace tyndall::physics {

/// Transform of a radial profile by the angular frequency `k`, 1/m: the integral of 2 pi r R(r) J0(k r).
using FrequencyFunction = std::function<glm::dvec3(double k)>;

/// R(r) = 1 / (2 pi) times the integral of k F(k) J0(k r), `r` metres from the middle. F may fall as slowly as 1/k: it
/// is faded out with two Gaussians of widths in proportion to 1/r, whose errors cancel up to the fourth order.
[[nodiscard]] glm::dvec3 inverse_hankel(const FrequencyFunction& f, double r);

}  // namespace tyndall::physics
