#ifndef TYNDALL_PHYSICS_KELEMEN
#define TYNDALL_PHYSICS_KELEMEN
#include "physics/ggx.glsl"
/// The mirror of skin's oily layer as d'Eon & Luebke (GPU Gems 3, 2007, 14.3) have it.

/// Kelemen & Szirmay-Kalos 2001 with Beckmann's distribution, without Fresnel, 1/sr: `noh` is the cosine of the half
/// vector to the normal, above 0, and `h2` the squared length of l + v, not normalised. The slope is ggx_alpha's. It has
/// the 1 / pi that makes it a BRDF, which the sources leave out.
FN float kelemen_brdf(float noh, float h2, float roughness) {
    float m2 = square(ggx_alpha(roughness));
    float c2 = noh * noh;
    return exp((c2 - 1.0f) / (c2 * m2)) * kInversePi / (m2 * c2 * c2 * h2);
}

#endif
