#pragma once
/// The kernel of diffusion as the levels of a light's map need it.

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <vector>

#include "radial_kernel.h"

namespace tyndall::translucency {

/// What the tables are made from.
struct KernelKey {
    Optics optics;
    Model model{};
    Scaling scaling{};
    float texel_m = 0.0f;     ///< of the first level
    int levels = 1;           ///< each with texels twice as wide
    float farthest_m = 0.0f;  ///< between two places of the body
    glm::vec3 scale{1.0f};    ///< of what leaves
    bool operator==(const KernelKey&) const = default;
};

/// For each level the exitance, 1/m2, of a texel through which a unit of flux enters, over the distance from its
/// middle.
struct LevelKernels {
    static constexpr int kColumns = 256;  ///< evenly over the root of the distance over the farthest

    /// Of the narrowest part of the first level's kernel, a Gaussian exp(-r^2 / width^2), metres.
    float first_width = 0.0f;
    /// What leaves at no distance, 1/m2, and over it the share of a pixel's own light that leaves within that part.
    glm::vec3 first_height{0.0f}, own_share{0.0f};
    std::vector<glm::vec4> table;  ///< a row a level; a: share that has forgotten where it entered
};

[[nodiscard]] LevelKernels make_level_kernels(const KernelKey& key);

/// Metres within which all but a five hundredth of the light leaves, in every channel.
[[nodiscard]] float reach_of(const RadialKernel& kernel);

}  // namespace tyndall::translucency
