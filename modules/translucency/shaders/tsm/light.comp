// The light that enters at each texel of a light's map and will leave somewhere.
#include "translucency/interior.glsl"
#include "render/shaders/lights.glsl"
#include "seams/light_transmittance.glsl"
#include "translucency/light_view.glsl"
#include "translucency/tsm/pyramid.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
uniform sampler2D entries;                               // map.frag
layout(r32f) writeonly uniform image2D light_spread;  // luminance times the square of metres beyond the middle
layout(rgba32f) writeonly uniform image2D light_map;  // rgb flux, lm, of a unit of the window; luminance times metres beyond the middle
uniform mat4 world_from_view;
uniform uint light_index;

/// What is seen in a texel and half a texel about it, weighted by a binomial: steps of the silhouette do not show. Of how
/// much of it something is seen is told by `share`.
vec4 entry_of(ivec2 texel, out float share, out float variance) {
    const vec4 kBinomial = vec4(1.0, 3.0, 3.0, 1.0) / 8.0;
    vec4 sum = vec4(0.0);
    share = variance = 0.0;
    for (int j = 0; j < 4; ++j)
        for (int i = 0; i < 4; ++i) {
            ivec2 at = clamp(2 * texel + ivec2(i, j) - 1, ivec2(0), textureSize(entries, 0) - 1);
            vec4 entry = texelFetch(entries, at, 0);
            float weight = kBinomial[i] * kBinomial[j];
            sum += weight * entry;
            share += entry.xyz != vec3(0.0) ? weight : 0.0;
            variance += weight * (entry.w - view.window.w) * (entry.w - view.window.w) * (entry.xyz != vec3(0.0) ? 1.0 : 0.0);
        }
    sum.xyz /= max(length(sum.xyz), 1e-6);
    sum.w /= max(share, 1e-6);
    variance = max(variance / max(share, 1e-6) - (sum.w - view.window.w) * (sum.w - view.window.w), 0.0);
    return sum;
}

void main() {
    ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
    float share, variance;
    vec4 entry = entry_of(texel, share, variance);
    vec2 at = view.window.xy + view.window.z * (vec2(texel) + 0.5) / float(map_size);
    float metres = window_metres(entry.w);
    vec3 p = (world_from_view * vec4(at * metres, entry.w, 1.0)).xyz;
    vec3 to_light;
    vec3 irradiance = light_irradiance(light_index, p, to_light);
    vec3 normal = dot(entry.xyz, to_light) < 0.0 ? -entry.xyz : entry.xyz;
    float cosine = clamp(dot(normal, to_light), 0.0, 1.0);
    vec4 found = vec4(0.0);
    float spread = 0.0;
    if (share > 0.0 && irradiance != vec3(0.0)) {
        // Across the ray a texel is as large whatever the surface's slope: no cosine of the surface.
        float area = share * metres * metres * mix(1.0, -dot(to_light, light_axis()), in_perspective());
        irradiance *= light_transmittance(light_index, p, normal);
        found.rgb = irradiance * (area * entering_share(cosine)) * leaving_share(cosine) * enters_to_wander(p);
        // it begins to spread where it first collides
        float z = entry.w + (1.0 - cosine * cosine) * first_path() - view.window.w;
        found.a = luminance_rec709(found.rgb) * z;
        spread = luminance_rec709(found.rgb) * (z * z + variance);
    }
    imageStore(light_spread, texel, vec4(spread));
    imageStore(light_map, texel, found);
}
