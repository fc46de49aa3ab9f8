#pragma once
/// How far light reaches around a body.

#include "radial_kernel.h"

namespace tyndall::translucency {

/// Wrapped light: what part of the mean keeps to the side of the light.
///
/// Of a surface's irradiance over all directions, with the mean of a clamped cosine c, the first moment is what tells
/// how far light reaches around. Diffusion over a sphere of the body's radius R leaves of it k = 1 - <r^2> / 2 R^2 (r:
/// the chords between where light enters and leaves). The wrap ((c + a) / (1 + a))^(1 + a) (2 + a) / 2 (1 + a) (Sloan
/// et al. 2011, Wrap Shading) has that mean for every a up to 1, and of the first moment 3 / (3 + a). All channels
/// share one a, since edges of their own would be seen as coloured belts; the rest of their moments comes of the widest
/// wrap, which ends nowhere, and of even light.
struct WrapAmount {
    float a = 0.0f;        ///< 0..1
    glm::vec3 wide{0.0f};  ///< share of the wrap of a = 1
    glm::vec3 even{0.0f};  ///< share of even light
};

/// None for an endless body.
[[nodiscard]] WrapAmount wrap_amount(const Optics& optics, Model model, float body_radius);

/// A wrap, as shaders/around.glsl has it.
[[nodiscard]] float wrapped(float cosine, float a);

}  // namespace tyndall::translucency
