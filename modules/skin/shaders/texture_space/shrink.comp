// A map from one twice as wide: means of four texels.
#include "skin/texture_space/atlas.glsl"

layout(rgba32f) readonly uniform image2D fine;
layout(rgba32f) writeonly uniform image2D map;
layout(rgba32f) readonly uniform image2D steps;
layout(r32f) readonly uniform image2D charts;
uniform int gutter;  // texels around the UVs' square

void main() {
    uint entry = list_entry();
    if (entry >= list_size) return;
    ivec2 at = map_texel(imageLoad(steps, list_texel(entry)).w);
    float chart = imageLoad(charts, list_texel(entry)).x;
    ivec2 low = 2 * at - gutter;
    vec4 sum = vec4(0.0);
    for (int i = 0; i < 4; ++i) {
        vec4 texel = imageLoad(fine, low + ivec2(i & 1, i >> 1));
        // in a corner no texel may have its middle in the chart
        sum += (texel.a == chart ? 1.0 : 1e-4) * vec4(texel.rgb, 1.0);
    }
    imageStore(map, at, vec4(sum.rgb / sum.a, chart));
}
