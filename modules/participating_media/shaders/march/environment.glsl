// Light from all around that one medium scatters along the eye ray, dimmed by all on its way to the eye. It changes slowly
// from place to place, so a few steps do.
#include "participating_media/environment.glsl"
#include "participating_media/march/guide.glsl"

uniform int medium;

const int kSteps = 4;

#ifndef GUIDE_ONLY
vec3 march(vec3 origin, vec3 direction, float t0, float t1, float offset) {
    float ds = (t1 - t0) / float(kSteps);
    vec3 before = media_transmittance(origin, direction, 0.0, t0);
    vec3 sum = vec3(0.0);
    for (int i = 0; i < kSteps; ++i) {
        float begin = t0 + float(i) * ds;
        vec3 step_depth = media_optical_depth(origin, direction, begin, begin + ds, 4);
        vec3 p = origin + direction * (begin + offset * ds);
        float amount = medium_density(medium, p) * environment_share(p);
        if (amount > 0.0)
            sum += amount * environment_transmittance(p) * before * mean_transmittance(step_depth) * ds;
        before *= exp(-step_depth);
    }
    return sum;
}
#endif

/// rgb radiance and a its guide of a pixel's ray.
vec4 march_pixel(ivec2 pixel, ivec2 noise_at) {
    vec3 origin = frame.eye_near.xyz;
    vec3 direction = eye_ray(pixel_uv(pixel));
    float t0 = 0.0, t1 = pixel_metres(pixel);
    if (!clip_to_medium(medium, origin, direction, t0, t1)) return vec4(0.0);
    vec3 scattered = media[medium].sigma_s_phase.rgb * environment_scattered(medium, origin, direction);
    float guide = luminance_rec709(scattered) * (t1 - t0);
#ifdef GUIDE_ONLY
    return vec4(vec3(0.0), guide);
#else
    return vec4(scattered * march(origin, direction, t0, t1, step_offset(noise_at)), guide);
#endif
}

#include "participating_media/march/main.glsl"
