#pragma once
/// A diffusion profile as few taps along a line.

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <vector>

#include "physics/diffusion_profile.h"

namespace tyndall::skin {

/// Half of a symmetric kernel along a line: the place of each tap in metres and its weights, the middle one first.
/// Weights of the middle and twice all others sum to 1 per channel.
struct LineKernel {
    std::vector<glm::vec4> taps;  ///< rgb weight, metres
};

/// The line spread of a profile over `taps_a_side` cells on each side of a middle one (after Jimenez et al. 2015,
/// Separable Subsurface Scattering, whose kernel is this one: edges and slits along the blur's direction are exact but
/// for the cells' size). A tap stands in its cell's centre of light and has all of the cell's light. Cells are narrower
/// where there is more light, and none narrower than `least_m`, the size of a pixel.
[[nodiscard]] LineKernel line_kernel(const physics::DiffusionProfile& profile, int taps_a_side, float least_m);

/// A tap of a kernel over the plane.
struct DiscTap {
    glm::vec2 place;   ///< metres
    glm::vec3 weight;  ///< all weights of a channel sum to 1
};

/// A profile over `count` rings, a tap in each at the golden angle from one to the next: the sampling of Christensen &
/// Burley (Approximate Reflectance Profiles for Efficient Subsurface Scattering, 2015) without its noise. Pixels of
/// `pixel_m` average what they and their eight neighbours found, each with its taps turned otherwise: the taps are as
/// much narrower. The first tap stands in the middle and is not averaged.
[[nodiscard]] std::vector<DiscTap> disc_kernel(const physics::DiffusionProfile& profile, int count, float pixel_m);

/// Beyond this the profile has next to no light, metres.
[[nodiscard]] float reach(const physics::DiffusionProfile& profile);

}  // namespace tyndall::skin
