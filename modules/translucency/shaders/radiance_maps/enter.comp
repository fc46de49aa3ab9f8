// What of one light enters an object through each texel of its map, and leaves it somewhere.
//
// entry_places: where it begins to spread, body's space; w: packed normal plus 1, 0 = nothing enters.
// entry_fluxes: lm; w: packed direction in which it goes on inside.
#include "translucency/interior.glsl"
#include "translucency/directions.glsl"
#include "translucency/radiance_maps/layers.glsl"
#include "render/shaders/lights.glsl"
#include "seams/light_transmittance.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
uniform sampler2DArray seen_places;
uniform sampler2DArray seen_scales;
layout(rgba32f) writeonly uniform image2DArray entry_places;
layout(rgba32f) uniform image2DArray entry_fluxes;
layout(r32f) uniform image2DArray entered;  // luminance of the flux when gathering began

uniform uint light_index;
uniform int first_layer;
uniform mat4 world_from_body;
uniform mat3 normals_to_world;
uniform mat3 body_from_world;

/// A change by more than this share counts.
const float kChange = 0.02;

void note_change(ivec3 texel, float before, float now) {
    float begun = state.restarted > 0u ? before : imageLoad(entered, texel).x;
    imageStore(entered, texel, vec4(begun));
    if (abs(now - begun) > kChange * max(now, begun)) atomicAdd(state.changed, 1u);
}

void main() {
    ivec3 texel = ivec3(gl_GlobalInvocationID.xy, first_layer + int(gl_GlobalInvocationID.z));
    if (texel.x >= light_resolution || texel.y >= light_resolution) return;
    vec4 seen = texelFetch(seen_places, texel, 0);
    vec4 flux = vec4(0.0), entry = vec4(seen.xyz, 0.0);
    if (seen.w > 0.0) {
        vec3 place = (world_from_body * vec4(seen.xyz, 1.0)).xyz;
        vec3 normal = normalize(normals_to_world * unpacked_normal(seen.w - 1.0));
        vec3 to_light;
        vec3 irradiance = light_irradiance(light_index, place, to_light);
        float cosine = clamp(dot(normal, to_light), 0.0, 1.0);
        if (cosine > 0.0 && irradiance != vec3(0.0)) {
            irradiance *= light_transmittance(light_index, place, normal);
            float through = entering_share(cosine) * texel_area(texel.z, seen.xyz);
            vec3 refracted = refract(-to_light, normal, 1.0 / interior_eta());
            flux.rgb = irradiance * texelFetch(seen_scales, texel, 0).rgb * leaving_share(cosine) *
                       slanted_scale(cosine) * through * enters_to_wander(place);
            flux.w = packed_normal(body_from_world * refracted);
            // it begins to spread where it first collides
            vec3 moved = (to_light - cosine * normal) * first_path();
            entry = vec4(seen.xyz - body_from_world * moved, seen.w);
        }
    }
    note_change(texel, luminance_rec709(imageLoad(entry_fluxes, texel).rgb), luminance_rec709(flux.rgb));
    imageStore(entry_fluxes, texel, flux);
    imageStore(entry_places, texel, entry);
}
