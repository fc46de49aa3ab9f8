// A material's factors times its maps. Only the maps that the features name exist (render/material_table.h).
#include "render/shaders/surfaces.glsl"

in vec4 v_uv;
flat in uint v_material;

#ifdef BASE_COLOUR_MAP
uniform sampler2D base_colour_map;
#endif
#ifdef METALLIC_ROUGHNESS_MAP
uniform sampler2D metallic_roughness_map;
#endif
#ifdef NORMAL_MAP
uniform sampler2D normal_map;
#endif
#ifdef OCCLUSION_MAP
uniform sampler2D occlusion_map;
#endif
#ifdef EMISSIVE_MAP
uniform sampler2D emissive_map;
#endif
#ifdef SPECULAR_MAP
uniform sampler2D specular_map;
#endif
#ifdef SPECULAR_COLOUR_MAP
uniform sampler2D specular_colour_map;
#endif

// Where map number `map` is looked up.
vec2 uv_of(int map) {
#ifdef UV_TRANSFORM
    vec4 row = materials[v_material].uv_rows[2 * map];
    vec3 uv = vec3(row.w > 0.5 ? v_uv.zw : v_uv.xy, 1.0);
    return vec2(dot(row.xyz, uv), dot(materials[v_material].uv_rows[2 * map + 1].xyz, uv));
#else
    return v_uv.xy;
#endif
}

// Base colour and alpha.
vec4 base_colour_at() {
    vec4 colour = materials[v_material].base_colour;
#ifdef BASE_COLOUR_MAP
    colour *= texture(base_colour_map, uv_of(0));
#endif
    return colour;
}
