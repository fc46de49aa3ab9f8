// A solid as the technique knows it: ScatterBlock of scatter_maps/scatter_block.h.
#include "physics/units.glsl"
#include "translucency/interior.glsl"

const int kSteps = 32, kCosines = 16, kRings = 6, kRingTaps = 6;
layout(std140) uniform ScatterMaps {
    vec4 extinction;  // rgb 1/m, index of refraction
    vec4 steps[kSteps];
    vec4 step_weights[kSteps];
    vec4 taps[kRings * kRingTaps];
    vec4 columns;
    vec4 body;
    vec4 green;
    vec4 green_amount;
} solid;

uniform sampler2D cosine_table;
uniform sampler2D kernel_table;  // rows: kernel, 1/m2, share from deep inside; thin_scale

/// The kernel at a squared distance.
vec4 kernel_here(float r2) { return textureLod(kernel_table, vec2(solid.columns.x + solid.columns.y * log2(r2), 0.25), 0.0); }
/// What is left of light that enters a wall so thick, metres: it leaves on both sides, on each as much as of thick ground.
vec3 thin_scale(float thickness) {
    return textureLod(kernel_table, vec2(solid.columns.x + solid.columns.y * 2.0 * log2(max(thickness, 1e-9)), 0.75), 0.0).rgb;
}

/// By a cosine, in a row of ScatterTables::cosines.
vec3 by_cosine(float cosine, float row) {
    return textureLod(cosine_table, vec2((cosine * float(kCosines - 1) + 0.5) / float(kCosines), (row + 0.5) * 0.25), 0.0).rgb;
}
/// Share of what enters at a cosine outside that leaves scattered more than once.
vec3 multiple_share(float cosine) { return by_cosine(cosine_inside(cosine), 0.0); }
/// Share of that which leaves nearer than the first ring.
vec3 own_share(float cosine) { return by_cosine(cosine, 1.0); }
/// What leaves toward a cosine outside over the mean: of light from near by, and from deep inside.
vec3 near_leaves(float cosine) { return by_cosine(cosine_inside(cosine), 2.0); }
vec3 deep_leaves(float cosine) { return by_cosine(cosine_inside(cosine), 3.0); }
