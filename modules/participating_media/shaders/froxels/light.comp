// Adds one light's share to the froxels' source.
#include "participating_media/froxels/sample.glsl"
#include "participating_media/froxels/scattering.glsl"
#include "render/shaders/lights.glsl"
#include "seams/light_transmittance.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

layout(rgba32f) uniform image3D froxel_source;
uniform uint light_index;
uniform ivec3 box_low;        // the froxels that the light reaches
uniform ivec3 box_size;
uniform uint light_media;     // those lit by it, a bit each

// Mean of 1 / d^2 over the sample's stretch, over 1 / d^2 where the sample is.
float near_light(FroxelSample s, vec3 p) {
#if LIGHT_KIND == 2
    return 1.0;
#else
    vec3 to_light = light_position(light_index) - s.origin;
    float closest = dot(to_light, s.direction);
    float width = 2.0 * s.t * frame.tan_half_fov_exposure.y / float(froxel_size.y);
    float passing = max(length(to_light - closest * s.direction), max(0.3 * width, 1e-3));
    float a = s.t0 - closest, b = s.t1 - closest;
    float angle = atan((b - a) * passing, passing * passing + a * b);
    vec3 offset = light_position(light_index) - p;
    return max(dot(offset, offset), 1e-4) * angle / (passing * max(b - a, 1e-6));
#endif
}

vec3 sample_source(FroxelSample s) {
    vec3 p = s.origin + s.t * s.direction;
    vec3 to_light;
    vec3 irradiance = light_irradiance(light_index, p, to_light) * near_light(s, p);
    float u = dot(to_light, s.direction);
#ifdef ONE_MEDIUM
    vec3 scattering = media[0].sigma_s_phase.rgb * sample_density(0, s) * medium_phase(0, u);
#else
    vec3 scattering = vec3(0.0);
    for (int i = 0; i < media_count; ++i)
        scattering += (light_media >> uint(i) & 1u) == 0u ? vec3(0.0) : media[i].sigma_s_phase.rgb * sample_density(i, s) * medium_phase(i, u);
#endif
    return irradiance * scattering * light_transmittance(light_index, p, vec3(0.0));
}

void main() {
    ivec3 froxel = box_low + ivec3(gl_GlobalInvocationID);
    if (any(greaterThanEqual(froxel, box_low + box_size))) return;
    vec4 source = imageLoad(froxel_source, froxel);
    int count = source.a <= 0.0 ? 0 : source.a >= 2.0 ? samples_alone : samples;
    vec3 sum = vec3(0.0);
    for (int i = 0; i < count; ++i) sum += sample_source(froxel_sample(froxel, i, count));
    source.rgb += (source.a - 1.0) * sum / float(max(count, 1));
    imageStore(froxel_source, froxel, source);
}
