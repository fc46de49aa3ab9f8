#pragma once
/// Light probes: spherical harmonics of an image of the surroundings.

#include <glm/glm.hpp>
#include <span>

#include "physics/physics.h"

namespace tyndall::physics {

/// Projects a latitude-longitude image (linear RGB, rows from the top, the layout of `direction_to_equirect`) onto nine
/// coefficients, each pixel by its solid angle. `pixels` holds width * height values.
[[nodiscard]] Sh9 project_equirect(std::span<const glm::vec3> pixels, int width, int height);

}  // namespace tyndall::physics
