// Fills a level of the clipmap: each voxel's mean extinction of uneven media.
#include "participating_media/media.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

layout(rgba16f) writeonly uniform image3D clipmap;
uniform vec3 level_low;
uniform vec3 level_voxel;  // metres
uniform int first_layer;
uniform int voxels;        // on a side
uniform int samples;       // along each axis of a voxel

bool medium_holds(int i, vec3 p) {
    vec3 local = medium_place(i, p);
    return all(lessThan(abs(local), vec3(0.5))) && media[i].shape.x * dot(local, local) < 0.25;
}

void main() {
    ivec3 voxel = ivec3(gl_GlobalInvocationID);
    if (any(greaterThanEqual(voxel, ivec3(voxels)))) return;
    vec3 low = level_low + vec3(voxel) * level_voxel;
    float spacing = min(level_voxel.x, min(level_voxel.y, level_voxel.z)) / float(samples);
    vec3 sum = vec3(0.0);
    for (int i = 0; i < media_count; ++i) {
        int count = medium_uneven(i) ? samples * samples * samples : 0;
        for (int s = 0; s < count; ++s) {
            vec3 at = (vec3(s % samples, (s / samples) % samples, s / (samples * samples)) + 0.5) / float(samples);
            vec3 p = low + at * level_voxel;
            float density = medium_density(i, p, spacing);
            sum += medium_holds(i, p) ? media[i].sigma_t.rgb * density : vec3(0.0);
        }
    }
    imageStore(clipmap, voxel + ivec3(0, 0, first_layer), vec4(sum / float(samples * samples * samples), 0.0));
}
