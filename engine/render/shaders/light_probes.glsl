// The indirect-light seam's provider "light_probes": probes and sky (render/light_probes.h: keep ProbeRecord the same).
#include "render/shaders/seam_types.glsl"
#include "render/shaders/probe_map.glsl"
#include "physics/sh.glsl"

struct ProbeRecord {
    mat4 local_from_world;
    vec4 extent_blend;  // half extents in metres, 0 = the whole scene; w metres over which it fades
    vec4 scale_layer;   // rgb multiplies the image; w its layer, -1 = white
    Sh9 harmonics;
};
layout(std430) readonly buffer Probes { ProbeRecord probes[]; };
uniform int probe_count;
uniform sampler2DArray probe_maps;

// How much a probe has to say at a point of its own space: 1 inside, 0 outside its box.
float probe_weight(vec4 extent_blend, vec3 p) {
    if (extent_blend.x <= 0.0) return 1.0;
    vec3 inside = extent_blend.xyz - abs(p);
    return clamp(min(inside.x, min(inside.y, inside.z)) / extent_blend.w, 0.0, 1.0);
}

// Where a ray inside the box meets its walls, seen from the centre: what the probe saw there.
vec3 parallax_corrected(vec4 extent_blend, vec3 p, vec3 direction) {
    if (extent_blend.x <= 0.0) return direction;
    vec3 inverse = 1.0 / mix(direction, vec3(1e-6), lessThan(abs(direction), vec3(1e-6)));
    vec3 distances = max((extent_blend.xyz - p) * inverse, (-extent_blend.xyz - p) * inverse);
    return normalize(p + direction * min(distances.x, min(distances.y, distances.z)));
}

IndirectLight light_probes_indirect(vec3 p, vec3 n, vec3 v, float roughness) {
    IndirectLight light;
    light.irradiance = vec3(0.0);
    light.specular = vec3(0.0);
    vec3 mirrored = reflect(-v, n);
    float left = 1.0;
    for (int i = 0; i < probe_count && left > 0.0; ++i) {
        vec3 local = (probes[i].local_from_world * vec4(p, 1.0)).xyz;
        vec4 extent_blend = probes[i].extent_blend;
        float weight = left * probe_weight(extent_blend, local);
        if (weight <= 0.0) continue;
        left -= weight;
        mat3 rotation = mat3(probes[i].local_from_world);
        vec4 scale_layer = probes[i].scale_layer;
        vec3 scale = weight * scale_layer.rgb;
        light.irradiance += scale * sh9_irradiance(probes[i].harmonics, rotation * n);
        if (scale_layer.w < 0.0) {
            light.specular += scale;
        } else {
            vec3 direction = parallax_corrected(extent_blend, local, rotation * mirrored);
            light.specular += scale * textureLod(probe_maps, vec3(probe_uv_from_direction(direction), scale_layer.w),
                                                 roughness * kProbeLastMip).rgb;
        }
    }
    return light;
}
