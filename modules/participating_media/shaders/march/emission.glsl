// What one medium gives off along the eye ray, dimmed by all on its way to the eye.
#include "participating_media/march/guide.glsl"
#include "participating_media/media.glsl"

uniform int medium;

const float kGuideKelvin = 1500.0;  // a flame

#ifndef GUIDE_ONLY
vec3 march(vec3 origin, vec3 direction, float t0, float t1, float offset) {
    float ds = (t1 - t0) / float(steps);
    vec3 to_eye = media_transmittance(origin, direction, 0.0, t0);
    float reached = t0;
    vec3 sum = vec3(0.0);
    int i = 0;
    do {
        float t = t0 + (float(i) + offset) * ds;
        vec3 p = origin + direction * t;
        to_eye *= exp(-media_optical_depth(origin, direction, reached, t, 1));
        reached = t;
        sum += medium_density(medium, p, ds) * medium_emission(medium, p) * to_eye * ds;
    } while (++i < steps && largest(to_eye) >= least_transmittance);
    return sum;
}
#endif

/// rgb radiance and a its guide of a pixel's ray.
vec4 march_pixel(ivec2 pixel, ivec2 noise_at) {
    vec3 origin = frame.eye_near.xyz;
    vec3 direction = eye_ray(pixel_uv(pixel));
    float t0 = 0.0, t1 = pixel_metres(pixel);
    if (!clip_to_medium(medium, origin, direction, t0, t1)) return vec4(0.0);
    float guide = luminance_rec709(media[medium].emission_even.rgb) * (t1 - t0);
    if (media[medium].temperature_size.x > 0.0)
        guide += luminance_rec709(media[medium].sigma_a.rgb * black_body_radiance(kGuideKelvin)) * (t1 - t0);
#ifdef GUIDE_ONLY
    return vec4(vec3(0.0), guide);
#else
    float offset = step_offset(noise_at);
    media_sample_offset = fixed_offset >= 0.0 ? 0.5 : fract(offset + 0.61803399);  // not the steps' own offset
    return vec4(march(origin, direction, t0, t1, offset), guide);
#endif
}

#include "participating_media/march/main.glsl"
