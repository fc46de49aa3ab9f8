// How the light of a map looks at the solid: ScatterViewBlock of scatter_maps/scatter_map.h.
//
// Places in the light's space: right, up, metres along its view. Depths in the map are less that of the solid's middle.
layout(std140) uniform LightView {
    vec4 origin_half;
    vec4 right_perspective;
    vec4 up_depth;
    vec4 forward_texel;
} view;

vec3 light_direction(vec3 d) {
    return vec3(dot(d, view.right_perspective.xyz), dot(d, view.up_depth.xyz), dot(d, view.forward_texel.xyz));
}
vec3 light_place(vec3 p) { return light_direction(p - view.origin_half.xyz); }
bool in_perspective() { return view.right_perspective.w > 0.0; }
/// What lengths across grow with: 1 or the depth.
float widening(float z) { return in_perspective() ? max(z, 1e-6) : 1.0; }
vec2 map_uv(vec3 at) { return 0.5 + 0.5 * at.xy / (view.origin_half.w * widening(at.z)); }
/// Metres across of a place in the map, at a depth.
vec2 across(vec2 uv, float z) { return (uv * 2.0 - 1.0) * view.origin_half.w * widening(z); }
/// Metres along the light's ray for a metre of depth.
float slant(vec3 at) { return in_perspective() ? length(at) / max(at.z, 1e-6) : 1.0; }
/// The mip whose texels cover so much, from its log2.
float map_lod(float log2_metres) { return max(log2_metres - view.forward_texel.w, 0.0); }
