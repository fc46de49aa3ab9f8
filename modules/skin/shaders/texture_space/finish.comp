// What the material does to light that enters, a texel of the light map each.
#include "skin/texture_space/atlas.glsl"
#include "skin/texture_space/slot.glsl"

layout(rgba32f) readonly uniform image2D steps;
layout(rgba32f) writeonly uniform image2D finish;
layout(r32f) writeonly uniform image2D occlusion;
uniform float gutter;
uniform float uv_size;
uniform vec2 tile;
uniform vec3 base_colour;
uniform float pre_scatter;
uniform float roughness;
uniform float occlusion_strength;
SLOT(base_colour_map)
SLOT(metallic_roughness_map)
SLOT(occlusion_map)

/// Level at which a map's texels are as large as the light map's.
float level_of(ivec2 size) { return max(log2(float(max(size.x, size.y)) / uv_size), 0.0); }

void main() {
    uint entry = list_entry();
    if (entry >= list_size) return;
    vec2 uv = (vec2(map_texel(imageLoad(steps, list_texel(entry)).w)) + 0.5 - gutter) / uv_size + tile;
    vec3 colour = base_colour;
    float rough = roughness, open = 1.0;
    if (base_colour_map_share > 0.0)
        colour *= textureLod(base_colour_map, base_colour_map_place(uv), level_of(textureSize(base_colour_map, 0))).rgb;
    if (metallic_roughness_map_share > 0.0)
        rough *= textureLod(metallic_roughness_map, metallic_roughness_map_place(uv), level_of(textureSize(metallic_roughness_map, 0))).g;
    if (occlusion_map_share > 0.0)
        open = textureLod(occlusion_map, occlusion_map_place(uv), level_of(textureSize(occlusion_map, 0))).r;
    imageStore(finish, list_texel(entry), vec4(pow(max(colour, vec3(kLeastColour)), vec3(pre_scatter)), rough));
    imageStore(occlusion, list_texel(entry), vec4(1.0 + occlusion_strength * (open - 1.0)));
}
