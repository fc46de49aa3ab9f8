// Places in a froxel at which light is looked at.
//
// All of them can be seen: each lies on the ray of one of the column's pixels and in front of that pixel's surface. Where
// the surface is before the froxel, the column's farthest pixel takes its place, and where that is too (the froxel is there for
// a neighbour's sake), the place is just in front of its surface. So nothing behind a wall is seen through it, however thin.
#include "participating_media/froxels/grid.glsl"
#include "physics/sequences.glsl"

uniform sampler2D scene_depth;
uniform sampler2D blue_noise;
uniform sampler2D froxel_columns;  // columns.comp
uniform int samples;               // of a froxel
uniform int samples_alone;         // of one without history
uniform int first_sample;          // of this frame, in the sequence; advances from frame to frame

struct FroxelSample {
    vec3 origin;
    vec3 direction;  // unit, from the eye
    float t0, t1;    // metres from the eye: what the sample stands for
    float t;         // and where it is
};

float froxel_dither(ivec3 froxel, ivec2 offset) { return texelFetch(blue_noise, (froxel.xy + froxel.z * ivec2(23, 41) + offset) & 63, 0).r; }

FroxelSample froxel_sample(ivec3 froxel, int i, int count) {
    uint index = uint(first_sample + i);
    vec2 within = fract(r2_sequence(index) + vec2(froxel_dither(froxel, ivec2(37, 11)), froxel_dither(froxel, ivec2(13, 29))));
    float along = fract(golden_ratio_sequence(index / uint(count)) + froxel_dither(froxel, ivec2(0)));
    along = (float(i) + along) / float(count);
    float z0 = froxel_depth(float(froxel.z) / float(froxel_size.z));
    float z1 = froxel_depth(float(froxel.z + 1) / float(froxel_size.z));
    ivec2 low = froxel_pixel(froxel.xy);
    ivec2 pixel = min(low + ivec2(within * vec2(froxel_pixel(froxel.xy + 1) - low)), ivec2(frame.size_time.xy) - 1);
    float depth = texelFetch(scene_depth, pixel, 0).r;
    float surface = depth > 0.0 ? view_depth(depth) : 1e30;
    vec2 uv = (vec2(pixel) + 0.5) / frame.size_time.xy;
    vec4 column = texelFetch(froxel_columns, froxel.xy, 0);
    uv = surface < z0 ? column.yz : uv;
    surface = surface < z0 ? column.x : surface;
    z0 = max(min(z0, surface - 0.25 * (z1 - z0)), 0.0);
    z1 = min(z1, surface);
    vec3 to_plane = eye_ray_to_plane(uv);
    float slope = length(to_plane);
    return FroxelSample(frame.eye_near.xyz, to_plane / slope, z0 * slope, z1 * slope, mix(z0, z1, along) * slope);
}
