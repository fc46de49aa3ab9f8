#pragma once
/// What the technique's shaders know of a solid.

#include <array>
#include <glm/vec4.hpp>
#include <vector>

#include "radial_kernel.h"
#include "scatter_maps/scatter_maps_settings.h"

namespace tyndall::translucency {

/// The uniform block "ScatterMaps" of shaders/scatter_maps/solid.glsl: keep both the same.
struct ScatterBlock {
    static constexpr int kSteps = 32, kCosines = 16, kRings = 6, kRingTaps = 6;
    glm::vec4 extinction;                        ///< rgb 1/m; w index of refraction
    glm::vec4 steps[kSteps];                     ///< metres along the eye's ray, metres that it stands for
    glm::vec4 step_weights[kSteps];              ///< rgb: sigma_s times the integral of what comes from there
    glm::vec4 taps[size_t(kRings) * kRingTaps];  ///< xy metres, z log2 of the metres that it stands for, w area, m2
    glm::vec4 columns;                           ///< log2 of a squared distance to a column of the table: x + y log2 r2
    glm::vec4 body;                              ///< rgb share that stays on a ball of the body's size; w its radius, m
    glm::vec4 green;                             ///< rgb 1/m by which form green fades; w share that goes through
    glm::vec4 green_amount;                      ///< rgb: what of that leaves at each place, where nothing has faded
};

/// All that it is made from.
struct ScatterKey {
    ScatteringInterior interior;  ///< its optics alone
    Model model{};
    Scaling scaling{};
    float body_radius = 0.0f;  ///< metres: 3 times the volume over the surface
    float extent = 0.0f;       ///< metres: half the map's width
    ScatterMapsSettings settings;
};
[[nodiscard]] bool same(const ScatterKey& a, const ScatterKey& b);

/// The block, and a table over the distance: the kernel in its first row, 1/m2, w: how much of it has come from deep
/// inside; in the second what is left of light that enters a wall of that thickness, since it leaves on both sides.
struct ScatterTables {
    static constexpr int kColumns = 256;
    /// Rows of `cosines`.
    enum Row { multiple, own, near, deep, kRows };
    ScatterBlock block{};
    std::array<std::vector<glm::vec4>, 2> kernel;
    /// Over cosines 0 to 1. By the cosine inside: share of what enters that leaves scattered more than once, patterns
    /// of light from near by and from deep inside over directions out; by the cosine to the light: share of what leaves
    /// that does so nearer than the first ring.
    std::array<std::array<glm::vec4, ScatterBlock::kCosines>, kRows> cosines{};
    float first_ring = 0.0f;  ///< metres
};
[[nodiscard]] ScatterTables scatter_tables(const ScatterKey& key);

/// Share of the light that enters a half-space at this cosine inside that leaves scattered exactly once: the integral
/// over directions out of albedo p(u) mu_o / (mu_i + mu_o) T(mu_o) (Chandrasekhar 1960, for any phase function).
[[nodiscard]] glm::vec3 single_share(const ScatteringInterior& interior, float cosine_inside);

}  // namespace tyndall::translucency
