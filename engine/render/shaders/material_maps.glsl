// A material's factors times its maps. Only the maps that the features name exist (render/material_table.h).

// The material of the draw: MaterialRecord of render/material_table.h. A uniform block, since software renderers fetch
// from it once for all pixels.
layout(std140) uniform MaterialBlock {
    vec4 base_colour;
    vec4 emissive_normal_scale;  // rgb cd/m2
    vec4 metallic_roughness_occlusion_cutoff;
    vec4 specular_colour_weight;
    vec4 ior_model;             // x index of refraction, y number of the shading model
    vec4 diffuse_transmission;  // rgb colour of what goes through, a its share
    vec4 paint;                 // rgb colour of what is painted over an interior, a its share
    vec4 uv_rows[20];           // two rows a map: xyz = row of the transform, w of the first = UV set
} material;

in vec4 v_uv;

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
#ifdef DIFFUSE_TRANSMISSION_MAP
uniform sampler2D diffuse_transmission_map;
#endif
#ifdef DIFFUSE_TRANSMISSION_COLOUR_MAP
uniform sampler2D diffuse_transmission_colour_map;
#endif
#ifdef PAINT_MAP
uniform sampler2D paint_map;
#endif

// Where map number `map` is looked up.
vec2 uv_of(int map) {
#ifdef UV_TRANSFORM
    vec4 row = material.uv_rows[2 * map];
    vec3 uv = vec3(row.w > 0.5 ? v_uv.zw : v_uv.xy, 1.0);
    return vec2(dot(row.xyz, uv), dot(material.uv_rows[2 * map + 1].xyz, uv));
#else
    return v_uv.xy;
#endif
}

// Base colour and alpha.
vec4 base_colour_at() {
    vec4 colour = material.base_colour;
#ifdef BASE_COLOUR_MAP
    colour *= texture(base_colour_map, uv_of(0));
#endif
    return colour;
}

// Colour and share of the diffuse light that goes through.
vec4 diffuse_transmission_at() {
    vec4 through = material.diffuse_transmission;
#ifdef DIFFUSE_TRANSMISSION_MAP
    through.a *= texture(diffuse_transmission_map, uv_of(7)).a;
#endif
#ifdef DIFFUSE_TRANSMISSION_COLOUR_MAP
    through.rgb *= texture(diffuse_transmission_colour_map, uv_of(8)).rgb;
#endif
    return through;
}

// Colour and share of what is painted.
vec4 paint_at() {
    vec4 paint = material.paint;
#ifdef PAINT_MAP
    paint *= texture(paint_map, uv_of(9));
#endif
    return paint;
}
