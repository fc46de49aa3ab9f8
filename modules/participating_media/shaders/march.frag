// Single scattering along the eye ray, marched light by light, only where the ray is inside a medium and the light's volume.
//
// Each step integrates what can be integrated: for directional lights the transmittance to the eye over the step, for point and spot
// lights the inverse-square law (steps of equal angle seen from the light: Kulla & Fajardo 2012). The rest is taken at one
// point of the step, jittered by blue noise, so that the mean over pixels has no bias.
#include "participating_media/media.glsl"
#include "render/shaders/frame.glsl"
#include "render/shaders/lights.glsl"
#include "seams/light_transmittance.glsl"

uniform sampler2D scene_depth;
uniform sampler2D blue_noise;
uniform int steps;
uniform int jitter;
uniform int light_count;
uniform int pixel_step;  // full-resolution pixels from one marched pixel to the next

out vec4 in_scatter;

struct Ray {
    vec3 origin;
    vec3 direction;
};

// The single-scattered radiance per metre that one light sends to the eye from p, without the inverse-square law's 1/d^2 when
// `inverse_square` carries it.
vec3 source(uint light, int medium, Ray ray, float t) {
    vec3 p = ray.origin + t * ray.direction;
    vec3 to_light;
    vec3 irradiance = light_irradiance(light, p, to_light);
    if (max(irradiance.r, max(irradiance.g, irradiance.b)) <= 0.0) return vec3(0.0);
    float phase = phase_evaluate(int(media[medium].sigma_s_phase.w), media[medium].phase_parameters, dot(to_light, ray.direction));
    return media[medium].sigma_s_phase.rgb * phase * irradiance * light_transmittance(light, p, vec3(0.0));
}

vec3 march_uniform(uint light, int medium, Ray ray, float t0, float t1, float offset) {
    float ds = (t1 - t0) / float(steps);
    vec3 sum = vec3(0.0);
    for (int i = 0; i < steps; ++i) {
        float begin = t0 + float(i) * ds;
        vec3 depth0 = media_optical_depth(ray.origin, ray.direction, 0.0, begin);
        vec3 depth1 = media_optical_depth(ray.origin, ray.direction, begin, begin + ds);
        sum += source(light, medium, ray, begin + offset * ds) * exp(-depth0) * mean_transmittance(depth1) * ds;
    }
    return sum;
}

vec3 march_equi_angular(uint light, int medium, Ray ray, float t0, float t1, float offset) {
    vec3 to_light = lights[light].position_range.xyz - ray.origin;
    float closest = dot(to_light, ray.direction);
    float passing = max(length(to_light - closest * ray.direction), 1e-3);
    float angle0 = atan((t0 - closest) / passing);
    float dangle = (atan((t1 - closest) / passing) - angle0) / float(steps);
    vec3 sum = vec3(0.0);
    for (int i = 0; i < steps; ++i) {
        float tangent = tan(angle0 + (float(i) + offset) * dangle);
        float t = clamp(closest + passing * tangent, t0, t1);
        // integral of 1/d^2 over the step = dangle / passing; `source` has 1/d^2 at t in it
        float metres = passing * (1.0 + tangent * tangent) * dangle;
        sum += source(light, medium, ray, t) * media_transmittance(ray.origin, ray.direction, 0.0, t) * metres;
    }
    return sum;
}

void main() {
    ivec2 pixel = min(ivec2(gl_FragCoord.xy) * pixel_step, ivec2(frame.size_time.xy) - 1);
    float depth = texelFetch(scene_depth, pixel, 0).r;
    vec2 uv = (vec2(pixel) + 0.5) / frame.size_time.xy;
    Ray ray = Ray(frame.eye_near.xyz, eye_ray(uv));
    float end = depth > 0.0 ? eye_distance(uv, depth) : 1e6;
    float offset = jitter != 0 ? texelFetch(blue_noise, ivec2(gl_FragCoord.xy) & 63, 0).r : 0.5;

    vec3 sum = vec3(0.0);
    for (int medium = 0; medium < media_count; ++medium) {
        float m0 = 0.0, m1 = end;
        if (!clip_to_medium(medium, ray.origin, ray.direction, m0, m1)) continue;
        for (uint light = 0u; light < uint(light_count); ++light) {
            float t0 = m0, t1 = m1;
            if (!light_segment(light, ray.origin, ray.direction, t0, t1)) continue;
            sum += int(lights[light].direction_kind.w) == LIGHT_DIRECTIONAL ? march_uniform(light, medium, ray, t0, t1, offset)
                                                                            : march_equi_angular(light, medium, ray, t0, t1, offset);
        }
    }
    in_scatter = vec4(sum, end);
}
