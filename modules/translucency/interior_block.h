#pragma once
/// What the shaders know of an interior.

#include "radial_kernel.h"

namespace tyndall::translucency {

/// Of InteriorBlock::rough: squares of numbers evenly from 0 to 1, since it is steep where light grazes.
inline constexpr int kRoughCosines = 32;

/// The uniform block "Interior" of shaders/interior.glsl: keep both the same.
struct InteriorBlock {
    glm::vec4 leaving[physics::HalfSpace::kCosines];  ///< share of what entered that leaves, by the cosine inside
    glm::vec4 deep[physics::HalfSpace::kCosines];     ///< pattern of light from deep inside, by the cosine inside
    glm::vec4 kernel[RadialKernel::kGaussians];       ///< weights of the kernel's Gaussians
    glm::vec4 mean_leaving;                           ///< share of diffuse light that has entered that leaves
    glm::vec4 base_entering;  ///< rgb base of the boundary's material; w share of diffuse light that enters
    glm::vec4 boundary;       ///< x index of refraction; y metres to the first collision; z 1 when as much leaves as is
                              ///< exact, 0 when the model decides
    glm::vec4 kernel_rate;  ///< x of the widest Gaussian, 1/m2; y at which light forgets where it entered, log2 a metre
    glm::vec4 sigma_s_reduced, sigma_a;               ///< 1/m
    glm::vec4 published;                              ///< what the published model is multiplied by
    glm::vec4 slanted[physics::HalfSpace::kCosines];  ///< directional: what flux is multiplied by for what the model
                                                      ///< returns too little of it, by the cosine inside
    glm::vec4 plane_wide, plane_narrow;  ///< shares of the kernel's integral over a plane that pairs of its
                                         ///< Gaussians have in the mean of the channels, the widest first
    glm::vec4 rough[kRoughCosines];      ///< x what a rough boundary mirrors over what a smooth one does, by
                                         ///< the cosine outside
};

/// All that an interior's GPU copy is made from.
struct InteriorKey {
    Optics optics;
    Model model{};
    Scaling scaling{};
    float piece_radius = 0.0f;  ///< metres
    float body_radius = 0.0f;   ///< metres: 3 times the volume over the surface, a sphere's radius; 0 = endless
    bool operator==(const InteriorKey&) const = default;
};

/// The albedo of a half-space that absorbs as much of the light that enters as a body of the size does. In diffusion a
/// sphere of radius R takes up coth(k R) - 1 / (k R) of what flat ground does at the same fluence (k = sigma_tr); for a
/// weak absorption that is volume over surface, whatever the shape (Blanco & Fournier 2003).
[[nodiscard]] glm::vec3 body_albedo(const Optics& optics, float body_radius);

/// Metres between collisions in the mean of the channels, of isotropic ones that are as good.
[[nodiscard]] float mean_free_path(const Optics& optics);
/// Light that leaves so far from where it entered, in metres, has forgotten where that was (by 1 - 1/e).
[[nodiscard]] float deep_distance(const Optics& optics);

/// What a rough boundary mirrors of the light at a cosine to the normal outside, over what a smooth one does: the GGX
/// lobe's integral over Schlick's reflectance. The rest enters, also after several meetings with the boundary.
[[nodiscard]] float mirrored_by_rough(float cosine, float eta, float roughness);

[[nodiscard]] InteriorBlock interior_block(const InteriorKey& key);

}  // namespace tyndall::translucency
