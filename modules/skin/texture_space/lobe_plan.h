#pragma once
/// Which blurs of a light map make a diffusion profile.

#include <glm/vec3.hpp>
#include <vector>

#include "physics/diffusion_profile.h"

namespace tyndall::skin {

/// One blur of what the one before left, and the share of the result in the whole.
struct LobeBlur {
    int level = 0;              ///< of the map: 0 as it is, 1 half as wide and so on
    float variance_m2 = 0.0f;   ///< that it adds
    float less_texels2 = 0.0f;  ///< off that variance in texels of its level: what changing levels and lookups spread
    int radius = 1;             ///< taps on each side
    glm::vec3 weight{0.0f};
};

/// d'Eon & Luebke's cascade (GPU Gems 3, 2007, 14.5.1): each Gaussian is made from the one before.
struct LobePlan {
    glm::vec3 sharp{0.0f};  ///< share of the light map as it is: lobes narrower than a bilinear lookup
    std::vector<LobeBlur> blurs;
    [[nodiscard]] int levels() const { return blurs.empty() ? 1 : blurs.back().level + 1; }
};

/// What a plan must know of the map.
struct LobeMap {
    float texel_m = 0.0f;  ///< mean side of a texel of level 0
    float densest = 1.0f;  ///< texels a metre where there are many (a percentile), over the mean
    int levels = 1;        ///< that there are
};
/// The most taps on each side of a blur.
inline constexpr int kMaxRadius = 6;

/// `profile` in metres of the map, narrowest lobe first. A wide lobe goes to a level where it spreads about a texel or
/// more: what going there and back spreads is taken off.
[[nodiscard]] LobePlan plan_lobes(const physics::DiffusionProfile& profile, const LobeMap& map);

/// For a blur of `radius` taps a side with weights q^(i^2): the q whose variance is that of each column, in texels
/// squared from 0 to (radius / kCutOff)^2; the same from where the Gaussian would be cut off nearer than at kCutOff
/// standard deviations.
inline constexpr int kKernelColumns = 64;
inline constexpr float kCutOff = 2.2f;
[[nodiscard]] std::vector<float> kernel_bases(int radius);

}  // namespace tyndall::skin
