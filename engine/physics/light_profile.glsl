#ifndef TYNDALL_PHYSICS_LIGHT_PROFILE
#define TYNDALL_PHYSICS_LIGHT_PROFILE
#include "physics/constants.glsl"
/// How a spot or point light's intensity falls off over angle, and the window that ends it at a range.

const int SPOT_SQUARED_LINEAR = 0;  ///< KHR_lights_punctual: the clamped ramp, squared
const int SPOT_SMOOTHSTEP = 1;      ///< 3 x^2 - 2 x^3 of the same ramp, as Blender's spots

/// Share of a spot's axial intensity, 0..1, in the direction at `cosine` to its axis: 1 within the inner cone, 0 beyond
/// the outer one; between them a ramp, linear in the cosine, through one of the profiles above.
FN float spot_falloff(int profile, float cosine, float cos_inner, float cos_outer) {
    float x = clamp((cosine - cos_outer) / max(cos_inner - cos_outer, 1e-4f), 0.0f, 1.0f);
    return profile == SPOT_SMOOTHSTEP ? x * x * (3.0f - 2.0f * x) : x * x;
}

/// The inner cosine that lets the ramp take the share `blend` (0..1) of 1 - cos_outer.
FN float spot_cos_inner_from_blend(float cos_outer, float blend) { return cos_outer + blend * (1.0f - cos_outer); }

/// Window (1 - (d/range)^4)^2, clamped: takes a light smoothly to 0 at its range (Karis 2013). NOT physical, a bound
/// for cost: it is 1 unless a range > 0 was given. Metres.
FN float range_window(float metres, float range) {
    if (range <= 0.0f) return 1.0f;
    float x = square(metres / range);
    return square(clamp(1.0f - x * x, 0.0f, 1.0f));
}

#endif
