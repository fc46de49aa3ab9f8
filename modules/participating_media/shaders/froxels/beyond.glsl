// What lies behind the froxels' grid: a few pieces a pixel, in each of which the integral has a closed form.
#include "participating_media/froxels/grid.glsl"
#include "participating_media/scattering.glsl"

uniform sampler2D scene_depth;
uniform uint beyond_media;  // a bit each

const int kPieces = 8;

struct Beyond {
    vec3 origin;
    vec3 direction;
    float t0, t1;  // metres from the eye
};

// The pixel's ray from the grid's end to its surface, as far as there is a medium; empty where t0 >= t1.
Beyond beyond_ray(vec2 uv) {
    float depth = texelFetch(scene_depth, ivec2(gl_FragCoord.xy), 0).r;
    vec3 to_plane = eye_ray_to_plane(uv);
    float slope = length(to_plane);
    float begin = froxel_depths.w * slope, end = depth > 0.0 ? view_depth(depth) * slope : 1e6;
    Beyond ray = Beyond(frame.eye_near.xyz, to_plane / slope, 1e6, 0.0);
    for (int i = 0; i < media_count; ++i) {
        float t0 = begin, t1 = end;
        bool inside = (beyond_media >> uint(i) & 1u) != 0u && clip_to_medium(i, ray.origin, ray.direction, t0, t1);
        ray.t0 = min(ray.t0, inside ? t0 : 1e6);
        ray.t1 = max(ray.t1, inside ? t1 : 0.0);
    }
    return ray;
}

// Metres of medium i's density between t0 and t1.
float beyond_column(int i, Beyond ray, float t0, float t1) {
    bool inside = (beyond_media >> uint(i) & 1u) != 0u && clip_to_medium(i, ray.origin, ray.direction, t0, t1);
    t1 = inside ? t1 : t0;
    return medium_column(i, ray.origin, ray.direction, t0, t1, 1);
}

// (1 - exp(-x)) / x for any x.
vec3 mean_exponential(vec3 x) { return mean_transmittance(abs(x)) * exp(max(-x, vec3(0.0))); }
