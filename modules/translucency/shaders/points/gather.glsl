// A cluster of points a work group, which looks at one list of nodes; eight points a thread share what is read of a node.
#define POINTS_A_THREAD 8
#define NODES_READ
#include "translucency/points/cloud.glsl"

uniform sampler2D lists;  // four nodes' numbers a texel
layout(std430) readonly buffer ListBegins { uint list_begins[]; };  // in texels

/// A thread's points follow at this stride; they are worked on by fours.
const uint kStride = 8u;
uint point_of_thread(uint i) { return gl_WorkGroupID.x * kStride * 8u + gl_LocalInvocationID.x + kStride * i; }

/// Exitance of four points, lm/m2, an element each; deep: luminance of what comes from deep inside.
struct Exitances {
    vec4 red, green, blue, deep;
};
vec4 exitance_of(Exitances all, uint i) { return vec4(all.red[i], all.green[i], all.blue[i], all.deep[i]); }

// Each Gaussian's rate is twice that of the one before, k r^2 with it.
#define GAUSSIAN(k) w = interior.kernel[k]; wide = g + g * spread * (kSpread * rates - 1.0); \
    kernel.red += w.r * wide; kernel.green += w.g * wide; kernel.blue += w.b * wide; kernel.deep += w.a * wide; \
    g *= g; rates += rates; spread += spread;

/// At four squared distances, by a group of nodes whose places vary by `variance` along each axis of the surface: to the
/// second order, the Gaussians' Laplacian there. Groups are seen neither edge-on nor face-on but in between: kSpread is 1
/// where they lie along the way to them, 0 where they face it.
const float kSpread = 0.75;
Exitances kernels_at(vec4 r2, float variance) {
    vec4 rates = interior.kernel_rate.x * r2;
    vec4 g = exp2(-1.44269504 * rates), wide, w;
    float spread = 2.0 * interior.kernel_rate.x * variance;
    Exitances kernel = Exitances(vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0));
    GAUSSIAN(15) GAUSSIAN(14) GAUSSIAN(13) GAUSSIAN(12) GAUSSIAN(11) GAUSSIAN(10) GAUSSIAN(9) GAUSSIAN(8)
    GAUSSIAN(7) GAUSSIAN(6) GAUSSIAN(5) GAUSSIAN(4) GAUSSIAN(3) GAUSSIAN(2) GAUSSIAN(1) GAUSSIAN(0)
    return kernel;
}

/// Four points, and what they have gathered.
struct Four {
    uvec4 points;
    vec4 x, y, z;
    Exitances sum;
};
Four four_of_thread(uint first) {
    Four four;
    four.sum = Exitances(vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0));
    for (uint i = 0u; i < 4u; ++i) {
        uint point = point_of_thread(first + i);
        vec3 place = piece_at(point).place;
        four.points[i] = point;
        four.x[i] = place.x;
        four.y[i] = place.y;
        four.z[i] = place.z;
    }
    return four;
}

void add_node(inout Four four, uint node, vec4 place, vec4 flux) {
    vec4 dx = four.x - place.x, dy = four.y - place.y, dz = four.z - place.z;
    Exitances kernel = kernels_at(dx * dx + dy * dy + dz * dz, place.w);
    vec4 other = mix(vec4(1.0), vec4(0.0), equal(four.points, uvec4(node)));
    four.sum.red += flux.r * other * kernel.red;
    four.sum.green += flux.g * other * kernel.green;
    four.sum.blue += flux.b * other * kernel.blue;
    four.sum.deep += flux.a * other * kernel.deep;
}

void add_node(inout Four low, inout Four high, uint node) {
    vec3 flux = texelFetch(node_fluxes, node_texel(node), 0).rgb;
    if (flux == vec3(0.0)) return;
    vec4 place = texelFetch(node_places, node_texel(node), 0);
    place.w = node < point_count ? 0.0 : place.w;
    vec4 all = vec4(flux, luminance(flux));
    add_node(low, node, place, all);
    add_node(high, node, place, all);
}

/// By the light that has entered everywhere but at the points themselves, not scaled there.
void gather(inout Four low, inout Four high) {
    uint last = list_begins[gl_WorkGroupID.x + 1u];
    for (uint i = list_begins[gl_WorkGroupID.x]; i < last; ++i) {
        uvec4 nodes = uvec4(texelFetch(lists, node_texel(i), 0));
        add_node(low, high, nodes.x);
        add_node(low, high, nodes.y);
        add_node(low, high, nodes.z);
        add_node(low, high, nodes.w);
    }
}
