// What one medium gives off along the eye ray, dimmed by all on its way to the eye.
#include "participating_media/media.glsl"
#include "render/shaders/frame.glsl"

uniform sampler2D scene_depth;
uniform sampler2D blue_noise;
uniform int steps;
uniform float fixed_offset;  // of a step; negative = by blue noise
uniform int medium;
uniform int pixel_step;  // full-resolution pixels from one marched pixel to the next
uniform float farthest;  // metres; rays that hit nothing end here

out vec4 glow;  // rgb radiance, a unused

void main() {
    ivec2 pixel = min(ivec2(gl_FragCoord.xy) * pixel_step, ivec2(frame.size_time.xy) - 1);
    float depth = texelFetch(scene_depth, pixel, 0).r;
    vec2 uv = (vec2(pixel) + 0.5) / frame.size_time.xy;
    vec3 origin = frame.eye_near.xyz;
    vec3 direction = eye_ray(uv);
    float t0 = 0.0, t1 = depth > 0.0 ? eye_distance(uv, depth) : farthest;
    float offset = fixed_offset >= 0.0 ? fixed_offset : texelFetch(blue_noise, ivec2(gl_FragCoord.xy) & 63, 0).r;
    media_sample_offset = fixed_offset >= 0.0 ? 0.5 : fract(offset + 0.61803399);  // not the steps' own offset
    glow = vec4(0.0);
    if (!clip_to_medium(medium, origin, direction, t0, t1)) return;
    float ds = (t1 - t0) / float(steps);
    vec3 to_eye = media_transmittance(origin, direction, 0.0, t0);
    float reached = t0;
    vec3 sum = vec3(0.0);
    for (int i = 0; i < steps; ++i) {
        float t = t0 + (float(i) + offset) * ds;
        vec3 p = origin + direction * t;
        to_eye *= exp(-media_optical_depth(origin, direction, reached, t, 1));
        reached = t;
        sum += medium_density(medium, p, ds) * medium_emission(medium, p) * to_eye * ds;
    }
    glow.rgb = sum;
}
