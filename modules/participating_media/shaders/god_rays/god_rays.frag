// Light of the sun scattered in an even medium, shaded by what the picture shows (Mitchell 2007; Livermore 2012, 4.2).
//
// The light's way to each point of the eye ray runs on the screen from the pixel toward the sun. A surface seen there
// shades those points of the ray whose light passes behind it, within a thickness that is assumed. The ray is cut into 64
// parts with equal shares of the unshadowed integral, one bit each; surfaces take bits away, and what is left of them is
// left of the integral. Nothing jumps as the sun leaves the picture or goes behind the camera: the way on the screen then
// leads to the picture's edge, and away from the point opposite to the sun; and toward the edge what stands there counts
// less and less, to be gone when it is out of sight: at the edge itself in none of four sets of bits, further in in all.
#include "participating_media/god_rays/even_sun.glsl"

uniform sampler2D scene_depth;
uniform float farthest;     // metres; rays that hit nothing end here
uniform vec3 sun_clip;      // x, y, w of the direction to the sun in clip space
uniform int samples;        // along the way on the screen
uniform float thickness;    // of what stands in the way, metres
uniform float edge_fade;    // of half the picture

in vec2 uv;
out vec4 in_scatter;  // rgb radiance, a unused

// How much of the unshadowed integral lies before t: exact at both ends, an exponential between.
float share_before(float t, float t0, float t1, float fall) {
    return (1.0 - exp(-fall * clamp((t - t0) / (t1 - t0), 0.0, 1.0))) / (1.0 - exp(-fall));
}

// Bits from `low` on.
uvec2 bits_from(int low) {
    return uvec2(low <= 0 ? ~0u : low >= 32 ? 0u : ~0u << low, low <= 32 ? ~0u : low >= 64 ? 0u : ~0u << (low - 32));
}

// Share of the integral that is lit, 0..1. Along the way u grows from 0; the sun is at u = 1 / sun_clip.z.
float lit_share(Ray ray, float t0, float t1, float fall) {
    vec2 from = uv * 2.0 - 1.0;
    vec2 way = sun_clip.xy - from * sun_clip.z;
    vec2 to_edge = (sign(way) - from) / mix(way, vec2(1e-9), lessThan(abs(way), vec2(1e-9)));
    float edge = max(min(to_edge.x, to_edge.y), 0.0);
    float last = sun_clip.z > 0.0 ? min(edge, 1.0 / sun_clip.z) : edge;
    float metres_per_depth = 1.0 / dot(ray.direction, -transpose(mat3(frame.view))[2]);
    float jitter = fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715))));  // Jimenez 2014
    float rounding = fract(jitter * 7.0);
    ivec2 size = textureSize(scene_depth, 0);
    uvec4 dark_low = uvec4(0u), dark_high = uvec4(0u);  // bits 0..31 and 32..63 of the four sets
    float surface_before = -1e9;
    vec2 t_before = vec2(0.0);
    for (int i = 0; i < samples; ++i) {
        float u = (float(i) + jitter) / float(samples) * last;
        vec2 place = from + u * way;
        ivec2 texel = clamp(ivec2((place + 1.0) * 0.5 * vec2(size)), ivec2(0), size - 1);
        vec2 inside = (1.0 - abs(place)) / edge_fade;
        float depth = texelFetch(scene_depth, texel, 0).r;
        // the ray's point of view depth z sends its light past u at the view depth z / (1 - u sun_clip.z)
        float surface = view_depth(max(depth, 1e-12));
        vec2 t = vec2(surface, surface + thickness) * (1.0 - u * sun_clip.z) * metres_per_depth;
        bool goes_on = abs(surface - surface_before) < thickness;  // the same thing: no gap between the two looks
        vec2 shaded = goes_on ? vec2(min(t.x, t_before.x), max(t.y, t_before.y)) : t;
        surface_before = surface;
        t_before = t;
        ivec2 bits = ivec2(floor(64.0 * vec2(share_before(shaded.x, t0, t1, fall), share_before(shaded.y, t0, t1, fall)) +
                                 rounding));
        uvec2 taken = depth > 0.0 ? bits_from(bits.x) & ~bits_from(bits.y) : uvec2(0u);
        uvec4 counts = mix(uvec4(0u), uvec4(~0u), lessThan((vec4(0.0, 1.0, 2.0, 3.0) + jitter) / 4.0, vec4(min(inside.x, inside.y))));
        dark_low |= taken.x & counts;
        dark_high |= taken.y & counts;
    }
    ivec4 dark = bitCount(dark_low) + bitCount(dark_high);
    return 1.0 - float(dark.x + dark.y + dark.z + dark.w) / 256.0;
}

void main() {
    float depth = texelFetch(scene_depth, ivec2(gl_FragCoord.xy), 0).r;
    Ray ray = Ray(frame.eye_near.xyz, eye_ray(uv));
    float t0 = 0.0, t1 = depth > 0.0 ? eye_distance(uv, depth) : farthest;
    in_scatter = vec4(0.0);
    if (!clip_to_medium(medium, ray.origin, ray.direction, t0, t1)) return;
    vec3 to_light;
    vec3 irradiance = light_irradiance(light_index, ray.origin, to_light);
    WayIn way = way_in(ray, to_light);
    float sigma_t = dot(media[medium].sigma_t.rgb, vec3(1.0 / 3.0));
    float fall = clamp(sigma_t * (t1 - t0 + metres_in(way, t1) - metres_in(way, t0)), -30.0, 30.0);
    fall = abs(fall) < 0.01 ? 0.01 : fall;
    in_scatter.rgb = media[medium].sigma_s_phase.rgb * irradiance * phase(dot(-to_light, -ray.direction)) *
                     unshadowed_integral(way, t0, t1) * lit_share(ray, t0, t1, fall);
}
