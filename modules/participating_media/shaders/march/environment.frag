// Light from all around that one medium scatters along the eye ray, dimmed by all on its way to the eye. It changes slowly
// from place to place, so a few steps do.
#include "participating_media/environment.glsl"
#include "render/shaders/frame.glsl"

uniform sampler2D scene_depth;
uniform sampler2D blue_noise;
uniform float fixed_offset;  // of a step; negative = by blue noise
uniform int medium;
uniform int once;        // 1: a loop that may be left out
uniform int pixel_step;  // full-resolution pixels from one marched pixel to the next
uniform float farthest;  // metres; rays that hit nothing end here

out vec4 glow;  // rgb radiance, a unused

const int kSteps = 4;

void main() {
    ivec2 pixel = min(ivec2(gl_FragCoord.xy) * pixel_step, ivec2(frame.size_time.xy) - 1);
    float depth = texelFetch(scene_depth, pixel, 0).r;
    vec2 uv = (vec2(pixel) + 0.5) / frame.size_time.xy;
    vec3 origin = frame.eye_near.xyz;
    vec3 direction = eye_ray(uv);
    float t0 = 0.0, t1 = depth > 0.0 ? eye_distance(uv, depth) : farthest;
    float offset = fixed_offset >= 0.0 ? fixed_offset : texelFetch(blue_noise, ivec2(gl_FragCoord.xy) & 63, 0).r;
    glow = vec4(0.0);
    if (!clip_to_medium(medium, origin, direction, t0, t1)) return;
    float ds = (t1 - t0) / float(kSteps);
    vec3 before = media_transmittance(origin, direction, 0.0, t0);
    vec3 sum = vec3(0.0);
    for (int i = 0; i < kSteps; ++i) {
        float begin = t0 + float(i) * ds;
        vec3 step_depth = media_optical_depth(origin, direction, begin, begin + ds, 4);
        vec3 p = origin + direction * (begin + offset * ds);
        float amount = medium_density(medium, p) * environment_share(p);
        for (int k = 0; k < (amount > 0.0 ? once : 0); ++k)
            sum += amount * environment_transmittance(p) * before * mean_transmittance(step_depth) * ds;
        before *= exp(-step_depth);
    }
    glow.rgb = media[medium].sigma_s_phase.rgb * environment_scattered(medium, origin, direction) * sum;
}
