// Single scattering of one light in one medium along the eye ray, marched only where the ray is inside the medium and
// the light's volume; draws of several lights and media add up.
//
// Each step integrates what can be integrated: for directional lights the transmittance to the eye over the step, for
// point and spot lights the inverse-square law (steps of equal angle seen from the light: Kulla & Fajardo 2012). The
// rest is taken at one point of the step, jittered by blue noise, so that the mean over pixels has no bias. The way to the
// eye is exact for even media, for blobs and for height fog; through noise and grids it is taken once a step.
#include "participating_media/light_source.glsl"

uniform sampler2D scene_depth;
uniform sampler2D blue_noise;
uniform int steps;
uniform float fixed_offset;  // of a step; negative = by blue noise
uniform int pixel_step;  // full-resolution pixels from one marched pixel to the next
uniform float farthest;  // metres; rays that hit nothing end here

out vec4 in_scatter;  // rgb radiance, a metres marched

#if LIGHT_KIND == 2  // LIGHT_DIRECTIONAL
vec3 march(Ray ray, float t0, float t1, float offset) {
    float ds = (t1 - t0) / float(steps);
    vec3 sum = vec3(0.0);
#if defined(ONE_MEDIUM) && defined(EVEN_MEDIA)
    vec3 step_depth = media[medium].sigma_t.rgb * ds;
    vec3 weight = mean_transmittance(step_depth) * ds;  // and the transmittance up to the step
    vec3 factor = exp(-step_depth);
    for (int i = 0; i < steps; ++i) {
        sum += source(ray, t0 + (float(i) + offset) * ds) * weight;
        weight *= factor;
    }
#else
    vec3 before = media_transmittance(ray.origin, ray.direction, 0.0, t0);
    for (int i = 0; i < steps; ++i) {
        float begin = t0 + float(i) * ds;
        vec3 step_depth = media_optical_depth(ray.origin, ray.direction, begin, begin + ds, 1);
        sum += source(ray, begin + offset * ds) * before * mean_transmittance(step_depth) * ds;
        before *= exp(-step_depth);
    }
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
    for (int i = 0; i < steps; ++i) {
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
        sum += source(ray, t) * to_eye * metres;
        at = vec2(at.x * turn.x - at.y * turn.y, at.y * turn.x + at.x * turn.y);
    }
    return sum;
}
#endif

void main() {
    ivec2 pixel = min(ivec2(gl_FragCoord.xy) * pixel_step, ivec2(frame.size_time.xy) - 1);
    float depth = texelFetch(scene_depth, pixel, 0).r;
    vec2 uv = (vec2(pixel) + 0.5) / frame.size_time.xy;
    Ray ray = Ray(frame.eye_near.xyz, eye_ray(uv));
    float end = depth > 0.0 ? eye_distance(uv, depth) : farthest;
    float offset = fixed_offset >= 0.0 ? fixed_offset : texelFetch(blue_noise, ivec2(gl_FragCoord.xy) & 63, 0).r;

    in_scatter = vec4(0.0, 0.0, 0.0, end);
    float t0 = 0.0, t1 = end;
    if (!clip_to_medium(medium, ray.origin, ray.direction, t0, t1)) return;
    float entry = t0;
    if (!light_segment(light_index, ray.origin, ray.direction, t0, t1)) return;
    in_scatter.rgb = media[medium].sigma_s_phase.rgb * march(ray, t0, t1, offset);
#if defined(ONE_MEDIUM) && defined(EVEN_MEDIA)
    in_scatter.rgb *= exp(-media[medium].sigma_t.rgb * (t0 - entry));
#endif
}
