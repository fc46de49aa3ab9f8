#pragma once
/// Hable, Borshukov and Hejl, Fast Skin Shading, ShaderX7, 2009: one kernel of thirteen jittered taps.

#include <array>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "physics/diffusion_profile.h"

namespace tyndall::skin {

struct HableTap {
    glm::vec2 offset{0.0f};  ///< metres on the surface
    glm::vec3 weight{0.0f};  ///< all weights of a channel sum to 1
};
inline constexpr int kHableTaps = 13;

/// Metres of a unit of the published offsets: with it the response to a knife edge is nearest to that of d'Eon &
/// Luebke's skin. RMS within 10 mm of the edge, mean over its directions: red 0.0249, green 0.0235, blue 0.0228; at
/// 0.40 mm it is 0.0261 0.0229 0.0230, at 0.50 mm 0.0260 0.0251 0.0235.
inline constexpr float kHableUnit_m = 0.45e-3f;

/// The published taps, the middle one first. For another profile their offsets are scaled to where its light is, and
/// each ring of taps has the light that leaves there.
[[nodiscard]] std::array<HableTap, kHableTaps> hable_taps(const physics::DiffusionProfile& profile);

/// Taps nearer to each other than `distance` metres as one, in their middle.
[[nodiscard]] std::vector<HableTap> merged(const std::array<HableTap, kHableTaps>& taps, float distance);

/// Response of the taps to a straight edge across `direction` (unit), `x` metres inside of it; 0..1.
[[nodiscard]] glm::vec3 hable_edge(const std::array<HableTap, kHableTaps>& taps, const glm::vec2& direction, float x);

}  // namespace tyndall::skin
