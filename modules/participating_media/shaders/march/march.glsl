// Single scattering of one light in one medium along the eye ray, marched only where the ray is inside the medium and
// the light's volume; draws of several lights and media add up.
//
// Each step integrates what can be integrated: for directional lights in even media the transmittance to the eye over the
// step, for point and spot lights the inverse-square law (steps of equal angle seen from the light: Kulla & Fajardo 2012). The
// rest is taken at one point of the step, jittered by blue noise, so that the mean over pixels has no bias. The way to the
// eye is exact for even media, for blobs and for height fog; through noise and grids it is taken once a step.
#include "participating_media/light_source.glsl"
#include "participating_media/march/guide.glsl"
#if SHADOW_MIPS == 1 && SHADOW_VIEWS == 1
#include "participating_media/march/lit_part.glsl"
#endif

#ifndef GUIDE_ONLY
#if LIGHT_KIND == 2  // LIGHT_DIRECTIONAL
vec3 march(Ray ray, float t0, float t1, float offset) {
    float ds = (t1 - t0) / float(steps);
    vec3 sum = vec3(0.0);
#if defined(ONE_MEDIUM) && defined(EVEN_MEDIA)
    vec3 step_depth = media[medium].sigma_t.rgb * ds;
    vec3 weight = mean_transmittance(step_depth) * ds;  // and the transmittance up to the step
    vec3 factor = exp(-step_depth);
    int i = 0;  // a loop that tests at its end: processors run the body of others once more than it has turns
    do {
        sum += source(ray, t0 + (float(i) + offset) * ds, ds) * weight;
        weight *= factor;
    } while (++i < steps);
#else
    // The way to the eye is taken at the very point whose light is taken: their means over the step would be correlated
    // where the density varies, and few steps would lose light.
    vec3 to_eye = media_transmittance(ray.origin, ray.direction, 0.0, t0);
    float reached = t0;
    int i = 0;
    do {
        float t = t0 + (float(i) + offset) * ds;
        to_eye *= exp(-media_optical_depth(ray.origin, ray.direction, reached, t, 1));
        reached = t;
        sum += source(ray, t, ds) * to_eye * ds;
    } while (++i < steps && largest(to_eye) >= least_transmittance);
#endif
    return sum;
}
#else
vec3 march(Ray ray, float t0, float t1, float offset) {
    vec3 to_light = light_position(light_index) - ray.origin;
    float closest = dot(to_light, ray.direction);
    float passing = max(length(to_light - closest * ray.direction), 1e-3);
    float angle0 = atan((t0 - closest) / passing);
    float dangle = (atan((t1 - closest) / passing) - angle0) / float(steps);
    // tan(a + b) by a rotation: one step turns (cos, sin) by dangle
    float start = angle0 + offset * dangle;
    vec2 at = vec2(cos(start), sin(start));
    vec2 turn = vec2(cos(dangle), sin(dangle));
    vec3 sum = vec3(0.0);
#if !defined(ONE_MEDIUM) || !defined(EVEN_MEDIA)
    vec3 to_eye = media_transmittance(ray.origin, ray.direction, 0.0, t0);
    float reached = t0;
#endif
    int i = 0;
    do {
        float tangent = at.y / at.x;
        float t = clamp(closest + passing * tangent, t0, t1);
        // the integral of 1/d^2 over the step is dangle / passing; `source` has 1/d^2 at t in it
        float metres = passing * (1.0 + tangent * tangent) * dangle;
#if defined(ONE_MEDIUM) && defined(EVEN_MEDIA)
        vec3 to_eye = exp(-media[medium].sigma_t.rgb * (t - t0));
#else
        to_eye *= exp(-media_optical_depth(ray.origin, ray.direction, reached, t, 1));
        reached = t;
#endif
        sum += source(ray, t, abs(metres)) * to_eye * metres;
        at = vec2(at.x * turn.x - at.y * turn.y, at.y * turn.x + at.x * turn.y);
#if defined(ONE_MEDIUM) && defined(EVEN_MEDIA)
    } while (++i < steps);
#else
    } while (++i < steps && largest(to_eye) >= least_transmittance);
#endif
    return sum;
}
#endif
#endif

/// The light's guide (output.glsl) on this part of the ray.
float guide_of(Ray ray, float t0, float t1) {
    const float kMeanPhase = 0.0795775;  // 1 / (4 pi): of a size with the guides of glows
    float weight = kMeanPhase * luminance_rec709(light_data(light_index).intensity_profile.rgb) * luminance_rec709(media[medium].sigma_s_phase.rgb);
#if LIGHT_KIND == 2
    return weight * (t1 - t0);
#else
    vec3 from_light = ray.origin - light_position(light_index);
    float along = dot(from_light, ray.direction);
    float passing = max(length(from_light - along * ray.direction), 1e-3);
    // of the part's ends: from the point nearest to the light, and one over the distance to it
    vec2 ends = along + vec2(t0, t1);
    vec2 nearness = inversesqrt(ends * ends + passing * passing);
    float turned = passing * passing + ends.x * ends.y;
    weight *= atan(passing * (t1 - t0), turned) / passing;  // the angle between them, precise when small
#if LIGHT_KIND == 1
    // the cone's profile in the middle of the angle: near the lamp a cone is narrower than a few pixels
    vec3 axis = light_data(light_index).direction_kind.xyz;
    vec2 cosines = (dot(from_light, axis) + vec2(t0, t1) * dot(ray.direction, axis)) * nearness;
    float middle = (cosines.x + cosines.y) * inversesqrt(max(2.0 + 2.0 * turned * nearness.x * nearness.y, 1e-6));
    weight *= spot_falloff(int(light_data(light_index).intensity_profile.w), middle,
                           light_data(light_index).up_cos_inner.w, light_data(light_index).right_cos_outer.w);
#endif
    return weight;
#endif
}

/// rgb radiance and a its guide of a pixel's ray.
vec4 march_pixel(ivec2 pixel, ivec2 noise_at) {
    Ray ray = Ray(frame.eye_near.xyz, eye_ray(pixel_uv(pixel)));
    float t0 = 0.0, t1 = pixel_metres(pixel);
    if (!clip_to_medium(medium, ray.origin, ray.direction, t0, t1)) return vec4(0.0);
    float entry = t0;
#if defined(ONE_MEDIUM) && defined(EVEN_MEDIA)
    t1 = min(t1, entry - log(max(least_transmittance, 1e-30)) / max(least(media[medium].sigma_t.rgb), 1e-30));
#endif
    if (!light_segment(light_index, ray.origin, ray.direction, t0, t1)) return vec4(0.0);
    float guide = guide_of(ray, t0, t1);
#ifdef GUIDE_ONLY
    return vec4(vec3(0.0), guide);
#else
    float offset = step_offset(noise_at);
#if SHADOW_MIPS == 1 && SHADOW_VIEWS == 1
    if (!clip_to_lit(ray.origin, ray.direction, t0, t1)) return vec4(vec3(0.0), guide);
#endif
    media_sample_offset = fixed_offset >= 0.0 ? 0.5 : fract(offset + 0.61803399);  // not the steps' own offset
    vec3 radiance = media[medium].sigma_s_phase.rgb * march(ray, t0, t1, offset);
#if defined(ONE_MEDIUM) && defined(EVEN_MEDIA)
    radiance *= exp(-media[medium].sigma_t.rgb * (t0 - entry));
#endif
    return vec4(radiance, guide);
#endif
}

#include "participating_media/march/main.glsl"
