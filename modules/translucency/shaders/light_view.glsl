// How a light looks at an object: LightView of light_view.h.
//
// Places in the light's space: right, up, metres along its view; in the window x / k, y / k, where k is that depth with
// perspective and 1 without.
layout(std140) uniform LightView {
    mat4 from_world;
    vec4 window;             // low corner, size, metres along the axis of the object's middle
    vec4 perspective_texel;  // x 0 or 1; y log2 of the metres that a texel covers at the middle
} view;

vec3 light_direction(vec3 d) { return mat3(view.from_world) * d; }
vec3 light_place(vec3 p) { return (view.from_world * vec4(p, 1.0)).xyz; }
/// The light's axis in the world.
vec3 light_axis() { return vec3(view.from_world[0].z, view.from_world[1].z, view.from_world[2].z); }
float in_perspective() { return view.perspective_texel.x; }
/// Metres that a unit of the window spans at a depth.
float window_metres(float z) { return mix(1.0, max(z, 1e-6), in_perspective()); }
vec2 map_uv(vec3 at) { return (at.xy / window_metres(at.z) - view.window.xy) / view.window.z; }
/// Metres across of a place in the map, at a depth.
vec2 across(vec2 uv, float z) { return (view.window.xy + view.window.z * uv) * window_metres(z); }
/// Metres along the light's ray for a metre of depth.
float slant(vec3 at) { return mix(1.0, length(at) / max(at.z, 1e-6), in_perspective()); }
/// The mip whose texels cover so much, from its log2.
float map_lod(float log2_metres) { return max(log2_metres - view.perspective_texel.y, 0.0); }
