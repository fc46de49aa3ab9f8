// TAPS taps instead of blurs (texture_space/hable_taps.h); those on other charts don't count. Whole texels: what lies
// between them is less than what the taps leave out.
#include "skin/texture_space/atlas.glsl"

layout(rgba32f) readonly uniform image2D map;
layout(rgba32f) writeonly uniform image2D result;
layout(rgba32f) readonly uniform image2D steps;
uniform vec2 tap_offsets[TAPS];  // metres of the map
uniform vec3 tap_weights[TAPS];

void main() {
    uint entry = list_entry();
    if (entry >= list_size) return;
    vec4 step = imageLoad(steps, list_texel(entry));
    ivec2 at = map_texel(step.w);
    float chart = imageLoad(map, at).a;
    vec3 light = vec3(0.0), weight = vec3(0.0);
    for (int i = 0; i < TAPS; ++i) {  // which compilers write out
        float rows = tap_offsets[i].y * step.z;
        vec4 tap = imageLoad(map, at + ivec2(round(vec2(tap_offsets[i].x * step.x + rows * step.y, rows))));
        vec3 counts = tap.a == chart ? tap_weights[i] : vec3(0.0);
        light += counts * tap.rgb;
        weight += counts;
    }
    imageStore(result, at, vec4(light / max(weight, vec3(1e-6)), chart));
}
