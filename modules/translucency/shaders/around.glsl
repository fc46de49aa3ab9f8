// Light that reaches a place around or through the body.
#include "render/shaders/lights.glsl"
#include "seams/light_transmittance.glsl"

uniform vec4 body_ball;  // middle, radius: holds the body
uniform float wrap_a;
uniform float wrap_lift;  // metres
uniform vec3 wrap_wide, wrap_even;  // WrapAmount of wrap/wrap_amount.h
uniform uint light_index;

/// What other things leave of the light on its way to the body: not shaded by the body itself.
vec3 transmittance_to_body(vec3 p, vec3 to_light) {
    vec3 offset = p - body_ball.xyz, unused;
    float along = dot(offset, to_light);
    float outside = -along + sqrt(max(along * along - dot(offset, offset) + body_ball.w * body_ball.w, 0.0));
    float distance_m = light_distance(light_index, p, unused);
    return light_transmittance(light_index, p + to_light * min(outside, 0.98 * distance_m), vec3(0.0));
}

/// What arrives, wrapped, at a place that faces the light by `cosine`: of what the light gives there, and around the body.
vec3 wrapped_light(vec3 irradiance, vec3 around, vec3 p, vec3 n, float cosine) {
    float above = max(cosine + wrap_a, 0.0) / (1.0 + wrap_a), half_cosine = 0.5 + 0.5 * cosine;
    float narrow = pow(above + 1e-9, 1.0 + wrap_a) * (2.0 + wrap_a) / (2.0 * (1.0 + wrap_a));
    // a little above the surface the body's own curve is in no light's way, and its other parts still are
    vec3 here = irradiance * light_transmittance(light_index, p + wrap_lift * n, n);
    return (vec3(1.0) - wrap_wide - wrap_even) * narrow * here +
           around * (wrap_wide * 0.75 * half_cosine * half_cosine + wrap_even * 0.25);
}
