// Places in a froxel at which light is looked at.
//
// All of them can be seen: each lies on the ray of one of the column's pixels and in front of that pixel's surface. For
// froxels behind that surface the ray of the column's farthest pixel takes its place, and where its surface is before them too
// (they are there for a neighbour's sake), the place is just in front of it. So nothing behind a wall is seen, however thin.
#include "participating_media/froxels/grid.glsl"
#include "physics/sequences.glsl"

uniform sampler2D scene_depth;
layout(r32f) readonly uniform image2D blue_noise;
layout(rgba32f) readonly uniform image2D froxel_columns;  // columns.comp
layout(rg32f) readonly uniform image2D froxel_reach;      // reach.comp
uniform int samples;        // of a froxel
uniform int samples_alone;  // of one without history
uniform int first_sample;   // of this frame, in the sequence; advances from frame to frame

// So many slices are looked at along one ray, and the next along another: less grain in their sum.
const int kSlicesARay = 8;

// A ray through a column, and how far one sees along it.
struct FroxelRay {
    vec3 origin;
    vec3 direction;  // unit
    float slope;     // metres along the ray for one along the eye's axis
    float surface;   // metres along the eye's axis
};

FroxelRay froxel_ray(vec2 uv, float surface) {
    vec3 to_plane = eye_ray_to_plane(uv);
    float slope = length(to_plane);
    return FroxelRay(frame.eye_near.xyz, to_plane / slope, slope, surface);
}

float froxel_mask(ivec3 first, ivec2 offset) { return imageLoad(blue_noise, (first.xy + first.z * ivec2(23, 41) + offset) & 63).r; }

// Sample i of a thread's rays.
FroxelRay froxel_ray(ivec3 first, vec4 column, int i) {
    vec2 within = fract(r2_sequence(uint(first_sample + i)) + vec2(froxel_mask(first, ivec2(37, 11)), froxel_mask(first, ivec2(13, 29))));
    ivec2 low = froxel_pixel(first.xy);
    ivec2 pixel = min(low + ivec2(within * vec2(froxel_pixel(first.xy + 1) - low)), ivec2(frame.size_time.xy) - 1);
    float surface = 1e30;
    float depth = texelFetch(scene_depth, pixel, 0).r;
    surface = depth > 0.0 ? view_depth(depth) : 1e30;
    return froxel_ray((vec2(pixel) + 0.5) / frame.size_time.xy, surface);
}

// Where in its slice a sample is, 0..1, before it shares the slice with others.
float froxel_dither(ivec3 first) {
    return froxel_mask(first, ivec2(0)) + golden_ratio_sequence(uint(first_sample));
}
float froxel_along(float dither, int slice, int i, int count) { return (float(i) + fract(dither + 0.61803399 * float(slice))) / float(count); }

// The part of a ray, in metres from the eye, that stands for the slice between the depths z0 and z1.
vec2 froxel_stretch(FroxelRay ray, float z0, float z1) {
    return vec2(max(min(z0, ray.surface - 0.25 * (z1 - z0)), 0.0), min(z1, ray.surface)) * ray.slope;
}

// The more of a froxel's light is this frame's, the more places are looked at.
float froxel_weight(float alpha) { return max(abs(alpha) - 1.0, 0.0); }
int froxel_samples(float alpha) {
    int most = alpha < 0.0 ? samples : samples_alone;  // stand-ins count little
    return alpha == 0.0 ? 0 : max(samples, int(ceil(float(most) * froxel_weight(alpha))));
}
