// Adds what the froxels' media give off themselves.
#include "participating_media/froxels/sample.glsl"
#include "participating_media/froxels/scattering.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

layout(rgba32f) uniform image3D froxel_source;
uniform uint glowing_media;  // a bit each

void main() {
    ivec3 froxel = ivec3(gl_GlobalInvocationID);
    if (any(greaterThanEqual(froxel, froxel_size))) return;
    vec4 source = imageLoad(froxel_source, froxel);
    int count = source.a <= 0.0 ? 0 : source.a >= 2.0 ? samples_alone : samples;
    vec3 sum = vec3(0.0);
    for (int k = 0; k < count; ++k) {
        FroxelSample s = froxel_sample(froxel, k, count);
        for (int i = 0; i < media_count; ++i)
            sum += (glowing_media >> uint(i) & 1u) == 0u ? vec3(0.0) : media[i].emission_even.rgb * sample_density(i, s);
    }
    source.rgb += (source.a - 1.0) * sum / float(max(count, 1));
    imageStore(froxel_source, froxel, source);
}
