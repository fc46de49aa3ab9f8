// Adds the light from all around that the froxels' media scatter.
#include "participating_media/environment.glsl"
#include "participating_media/froxels/sample.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

layout(rgba32f) uniform image3D froxel_source;
uniform uint lit_media;  // a bit each

// Mean radiance per metre that goes to the eye from the stretch.
vec3 source(FroxelRay ray, vec2 stretch, float along) {
    vec3 sum = vec3(0.0);
    for (int i = 0; i < media_count; ++i) {
        float t0 = stretch.x, t1 = stretch.y;
        bool inside = (lit_media >> uint(i) & 1u) != 0u && clip_to_medium(i, ray.origin, ray.direction, t0, t1);
        float share = inside ? (t1 - t0) / (stretch.y - stretch.x) : 0.0;
        vec3 p = ray.origin + mix(t0, t1, along) * ray.direction;
        sum += inside ? share * medium_density(i, p) * media[i].sigma_s_phase.rgb * environment_scattered(i, p, ray.direction) : vec3(0.0);
    }
    vec3 p = ray.origin + mix(stretch.x, stretch.y, along) * ray.direction;
    return sum * environment_share(p) * environment_transmittance(p);
}

void main() {
    ivec3 first = ivec3(gl_GlobalInvocationID) * ivec3(1, 1, slices_a_thread);
    if (any(greaterThanEqual(first, froxel_size))) return;
    int end = min(first.z + slices_a_thread, froxel_size.z);
    float reach = imageLoad(froxel_reach, first.xy).x;
    vec4 column = imageLoad(froxel_columns, first.xy);
    FroxelRay far = froxel_ray(column.yz, column.x);
    float z0 = froxel_depth(float(first.z) / float(froxel_size.z));
    do {
        float dither = froxel_dither(first);
        FroxelRay ray = froxel_ray(first, column, 0);
        int k = 0;
        do {
            ivec3 place = froxel_place(first + ivec3(0, 0, k));
            float z1 = froxel_end(z0);
            if (z0 > ray.surface) ray = far;
            vec4 froxel = imageLoad(froxel_source, place);
            vec2 stretch = froxel_stretch(ray, z0, z1);
            stretch.y = froxel.a != 0.0 ? stretch.y : stretch.x;
            froxel.rgb += froxel_weight(froxel.a) * source(ray, stretch, froxel_along(dither, k, 0, 1));
            imageStore(froxel_source, place, froxel);
            z0 = z1;
        } while (++k < min(kSlicesARay, end - first.z));
        first.z += kSlicesARay;
    } while (first.z < end && z0 < reach);
}
