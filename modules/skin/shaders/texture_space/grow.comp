// Adds what was made of a coarser map, and a share of a map as it is.
#include "skin/texture_space/atlas.glsl"

layout(rgba32f) uniform image2D total;
layout(rgba32f) readonly uniform image2D map;
layout(rgba32f) readonly uniform image2D steps;
layout(r32f) readonly uniform image2D charts;
uniform sampler2D coarse;
uniform float coarse_share;  // 0: there is none
uniform vec3 sharp;
uniform float keeps;
uniform float gutter;

void main() {
    uint entry = list_entry();
    if (entry >= list_size) return;
    ivec2 at = map_texel(imageLoad(steps, list_texel(entry)).w);
    vec3 all = vec3(0.0);
    if (coarse_share != 0.0) {
        vec2 place = 0.5 * (vec2(at) + 0.5 - gutter) + gutter;
        all += textureLod(coarse, place / vec2(textureSize(coarse, 0)), 0.0).rgb;
    }
    if (sharp != vec3(0.0)) all += sharp * imageLoad(map, at).rgb;
    if (keeps != 0.0) all += imageLoad(total, at).rgb;
    imageStore(total, at, vec4(all, imageLoad(charts, list_texel(entry)).x));
}
