#pragma once
/// Light probes: what an image of the surroundings shines, as spherical harmonics and as lights.

#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "physics/physics.h"

namespace tyndall::physics {

/// Projects a latitude-longitude image (linear RGB, rows from the top, the layout of `direction_to_equirect`) onto nine
/// coefficients, each pixel by its solid angle. `pixels` holds width * height values.
[[nodiscard]] Sh9 project_equirect(std::span<const glm::vec3> pixels, int width, int height);

/// A light from far away that stands for a part of the surroundings.
struct DistantLight {
    glm::vec3 direction{0.0f, 1.0f, 0.0f};  ///< unit, toward the light, in the image's space
    glm::vec3 illuminance{0.0f};            ///< on a plane that faces it; lux where the image is in cd/m2
};

/// The same image as `count` lights of equal luminance (Pharr & Humphreys 2004; Dal Corso 2014, 4.4): places of a
/// lattice in the unit square go through the inverse of the image's cumulated luminance times solid angle, first the
/// rows', then that of the row's pixels; each is its pixel's radiance over count times density. Fewer where several
/// fall into one pixel, which is one light then; none for a black image. The same image gives the same lights.
///
/// The lattice is (i + 1/2) / count by the golden-ratio sequence: for 16 to 128 lights of five skies and rooms the
/// irradiance of planes of all orientations has half of the relMSE that Hammersley's set gives (median).
[[nodiscard]] std::vector<DistantLight> lights_of_equirect(std::span<const glm::vec3> pixels, int width, int height,
                                                           int count);

}  // namespace tyndall::physics
