// The next level of a light's map: flux and where it entered, weighted by it, over 4x4 texels of the finer one. The weights
// are a binomial, which follows slanted silhouettes more smoothly than the mean of 2x2. What would spread beyond the border
// is turned back, so that no light is lost.
#include "translucency/tsm/pyramid.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
uniform int level;  // that is made
layout(rgba32f) uniform image2D light_map;
layout(r32f) uniform image2D light_spread;

void main() {
    const vec4 kBinomial = vec4(1.0, 3.0, 3.0, 1.0) / 8.0;
    ivec2 texel = ivec2(gl_GlobalInvocationID.xy), finer = level_origin(level - 1);
    int last = (map_size >> (level - 1)) - 1;
    vec4 light = vec4(0.0);
    float spread = 0.0;
    for (int j = 0; j < 4; ++j)
        for (int i = 0; i < 4; ++i) {
            ivec2 at = finer + clamp(2 * texel + ivec2(i, j) - 1, ivec2(0), ivec2(last));
            light += kBinomial[i] * kBinomial[j] * imageLoad(light_map, at);
            spread += kBinomial[i] * kBinomial[j] * imageLoad(light_spread, at).x;
        }
    if (max(texel.x, texel.y) >= map_size >> level) return;
    imageStore(light_map, level_origin(level) + texel, light);
    imageStore(light_spread, level_origin(level) + texel, vec4(spread));
}
