// One light behind the froxels' grid.
//
// Within a piece the optical depth to a directional light is linear in the optical depth to the eye, exactly so in even
// media and in height fog: with depths a + b x and tau x over the piece the integral is
// scattered / tau exp(-a) (1 - exp(-(tau + b))) / (tau + b). For other lights the inverse-square law is integrated. Shadows
// and gobos are looked at in one place of a piece, another for each pixel.
#include "participating_media/froxels/beyond.glsl"
#include "physics/sequences.glsl"
#include "render/shaders/lights.glsl"
#include "seams/light_transmittance.glsl"

uniform uint light_index;

in vec2 uv;
out vec4 in_scatter;  // rgb radiance, a unused

vec3 scattered(Beyond ray, float t0, float t1, float u) {
    vec3 sum = vec3(0.0);
    for (int i = 0; i < media_count; ++i)
        sum += media[i].sigma_s_phase.rgb * beyond_column(i, ray, t0, t1) * medium_phase(i, u);
    return sum;
}

// Where piece k begins, 0..kPieces: with distance for directional lights, at equal angles seen from others.
float piece(Beyond ray, float k) {
    float share = k / float(kPieces);
#if LIGHT_KIND == 2
    return ray.t0 * pow(ray.t1 / ray.t0, share);
#else
    vec3 to_light = light_position(light_index) - ray.origin;
    float closest = dot(to_light, ray.direction);
    float passing = max(length(to_light - closest * ray.direction), 1e-3);
    return clamp(closest + passing * tan(mix(atan((ray.t0 - closest) / passing), atan((ray.t1 - closest) / passing), share)), ray.t0, ray.t1);
#endif
}

// Mean of 1 / d^2 over a piece, over 1 / d^2 at the place that is looked at.
float near_light(Beyond ray, float t0, float t1, float t) {
#if LIGHT_KIND == 2
    return 1.0;
#else
    vec3 to_light = light_position(light_index) - ray.origin;
    float closest = dot(to_light, ray.direction);
    float passing = max(length(to_light - closest * ray.direction), 1e-3);
    float a = t0 - closest, b = t1 - closest, at = t - closest;
    return (passing * passing + at * at) * atan((b - a) * passing, passing * passing + a * b) / (passing * max(b - a, 1e-6));
#endif
}

void main() {
    in_scatter = vec4(0.0);
    Beyond ray = beyond_ray(uv);
    if (ray.t0 >= ray.t1 || !light_segment(light_index, ray.origin, ray.direction, ray.t0, ray.t1)) return;
    ray.t0 = max(ray.t0, 1e-3);
    vec3 before = media_transmittance(ray.origin, ray.direction, 0.0, ray.t0);
    float t = ray.t0;
#if LIGHT_KIND == 2
    vec3 to_sun = -light_data(light_index).direction_kind.xyz;
    vec3 a = media_optical_depth(ray.origin + t * ray.direction, to_sun, 0.0, LIGHT_FAR, media_light_steps);
#endif
    float dither = interleaved_gradient_noise(gl_FragCoord.xy);
    for (int k = 0; k < kPieces; ++k) {
        float next = piece(ray, float(k + 1)), at = piece(ray, float(k) + dither);
        vec3 p = ray.origin + at * ray.direction;
        vec3 to_light;
        vec3 irradiance = light_irradiance(light_index, p, to_light) * near_light(ray, t, next, at);
        vec3 light = irradiance * scattered(ray, t, next, dot(to_light, ray.direction)) * light_transmittance(light_index, p, vec3(0.0));
        vec3 tau = media_optical_depth(ray.origin, ray.direction, t, next, 1);
#if LIGHT_KIND == 2
        vec3 end = media_optical_depth(ray.origin + next * ray.direction, to_sun, 0.0, LIGHT_FAR, media_light_steps);
        in_scatter.rgb += before * light * mean_exponential(tau + end - a) * exp(min((at - t) / max(next - t, 1e-6) * (end - a), vec3(20.0)));
        a = end;
#else
        in_scatter.rgb += before * light * mean_transmittance(tau);
#endif
        before *= exp(-tau);
        t = next;
    }
}
