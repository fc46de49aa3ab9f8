// Sums the sources front to back (Hillaire 2015): V = (L + T S ds (1 - Ts) / (sigma_t ds), T Ts), each slice's source seen
// through the slices before it. T is the transmittance of all media, whoever renders them.
//
// Layer k of the sum reaches from the eye to the beginning of slice k; alpha is the mean transmittance.
#include "participating_media/froxels/grid.glsl"
#include "participating_media/media.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

layout(rgba32f) readonly uniform image3D froxel_source;
layout(rg32f) readonly uniform image2D froxel_reach;
layout(rgba32f) writeonly uniform image3D froxel_radiance;

void main() {
    ivec2 column = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(column, froxel_size.xy))) return;
    vec3 to_plane = eye_ray_to_plane((vec2(column) + 0.5) / vec2(froxel_size.xy));
    float slope = length(to_plane);
    vec3 direction = to_plane / slope, origin = frame.eye_near.xyz;
    float t = froxel_depths.x * slope;
    vec3 radiance = vec3(0.0), before = media_transmittance(origin, direction, 0.0, t);
    imageStore(froxel_radiance, froxel_place(ivec3(column, 0)), vec4(radiance, dot(before, vec3(1.0 / 3.0))));
    float end = min(imageLoad(froxel_reach, column).x, froxel_depths.w) * slope;  // nobody looks farther
    int k = 0;
    do {
        float next = t + froxel_step * (t + (froxel_depths.y - froxel_depths.x) * slope);
        vec3 depth = media_optical_depth(origin, direction, t, next, 1);
        radiance += before * imageLoad(froxel_source, froxel_place(ivec3(column, k))).rgb * mean_transmittance(depth) * (next - t);
        before *= exp(-depth);
        t = next;
        imageStore(froxel_radiance, froxel_place(ivec3(column, ++k)), vec4(radiance, dot(before, vec3(1.0 / 3.0))));
    } while (k < froxel_size.z && t < 1.001 * end);
}
