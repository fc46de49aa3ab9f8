// Fills the gutters, from the list's entry list_begin on, with what lies across the border.
#include "skin/texture_space/atlas.glsl"

layout(rgba32f) uniform image2D map;
layout(rgba32f) readonly uniform image2D taps;
layout(rgba32f) readonly uniform image2D weights;
layout(r32f) readonly uniform image2D gutter_charts;
uniform uint list_begin;

void main() {
    uint entry = list_begin + list_entry();
    if (entry >= list_size) return;
    vec4 from = imageLoad(taps, list_texel(entry));
    vec4 weight = imageLoad(weights, list_texel(entry));
    float chart = imageLoad(gutter_charts, list_texel(entry)).x;
    vec3 light = weight.x * imageLoad(map, map_texel(from.x)).rgb + weight.y * imageLoad(map, map_texel(from.y)).rgb +
                 weight.z * imageLoad(map, map_texel(from.z)).rgb +
                 max(1.0 - weight.x - weight.y - weight.z, 0.0) * imageLoad(map, map_texel(from.w)).rgb;
    imageStore(map, map_texel(weight.w), vec4(light, chart));
}
