// Puts light that has spread in a map in place of what arrives at the pixels. HABLE: spreads it here, by thirteen taps.
#include "render/shaders/frame.glsl"
#include "render/shaders/gbuffer.glsl"
#include "skin/texture_space/slot.glsl"

in vec2 v_uv;
layout(location = 0) out vec4 light_diffuse;

uniform sampler2D scene_depth;
uniform sampler2D gbuffer_surface;
uniform sampler2D map;
uniform vec4 map_from_uv;  // scale, offset: to 0..1 over the map
uniform float number;      // of the surface
#ifdef COLOURED
uniform vec3 base_colour;
uniform float pre_scatter;
SLOT(base_colour_map)
#endif
#ifdef HABLE
uniform sampler2D map_steps;
uniform vec2 tap_offsets[13];  // metres of the map
uniform vec3 tap_weights[13];

vec3 spread_light(vec2 place) {
    vec2 texel = 1.0 / vec2(textureSize(map, 0));
    vec3 steps = texelFetch(map_steps, ivec2(place / texel), 0).xyz;
    vec3 light = vec3(0.0), weight = vec3(1e-6);
    for (int i = 0; i < 13; ++i) {
        float rows = tap_offsets[i].y * steps.z;
        vec4 tap = textureLod(map, place + texel * vec2(tap_offsets[i].x * steps.x + rows * steps.y, rows), 0.0);
        light += tap_weights[i] * tap.rgb;
        weight += tap_weights[i] * tap.a;
    }
    return light / weight;
}
#else
vec3 spread_light(vec2 place) { return textureLod(map, place, 0.0).rgb; }
#endif

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    // another surface, or another part of this one, is in front
    if (surface_number(texelFetch(gbuffer_surface, pixel, 0)) != number) discard;
    float depth = texelFetch(scene_depth, pixel, 0).x;
    if (depth <= 0.0 || abs(view_depth(depth) * gl_FragCoord.w - 1.0) > 5e-4) discard;
    vec3 light = spread_light(v_uv * map_from_uv.xy + map_from_uv.zw);
#ifdef COLOURED
    vec3 colour = base_colour;
    if (base_colour_map_share > 0.0) colour *= texture(base_colour_map, base_colour_map_place(v_uv)).rgb;
    light /= pow(max(colour, vec3(kLeastColour)), vec3(pre_scatter));
#endif
    light_diffuse = vec4(light, 0.0);
}
