// A cluster of points a work group, which looks at one list of nodes; eight points a thread share what is read of a node.
#define POINTS_A_THREAD 8
#define NODES_READ
#include "translucency/points/cloud.glsl"

uniform sampler2D lists;  // nodes' numbers
layout(std430) readonly buffer ListBegins { uint list_begins[]; };

/// A thread's points follow at this stride; they are worked on by fours.
const uint kStride = 8u;
uint point_of_thread(uint i) { return gl_WorkGroupID.x * kStride * 8u + gl_LocalInvocationID.x + kStride * i; }

/// Exitance of four points, lm/m2, an element each; deep: luminance of what comes from deep inside.
struct Exitances {
    vec4 red, green, blue, deep;
};
vec4 exitance_of(Exitances all, uint i) { return vec4(all.red[i], all.green[i], all.blue[i], all.deep[i]); }

// Each Gaussian's rate is twice that of the one before, k r^2 with it.
#define ALL_GAUSSIANS GAUSSIAN(15) GAUSSIAN(14) GAUSSIAN(13) GAUSSIAN(12) GAUSSIAN(11) GAUSSIAN(10) GAUSSIAN(9) \
    GAUSSIAN(8) GAUSSIAN(7) GAUSSIAN(6) GAUSSIAN(5) GAUSSIAN(4) GAUSSIAN(3) GAUSSIAN(2) GAUSSIAN(1) GAUSSIAN(0)

/// What leaves at four squared distances for a unit of flux, 1/m2, a channel each.
struct Kernels {
    vec4 red, green, blue;
};

/// From a point.
Kernels kernels_of_point(vec4 r2) {
    vec4 g = exp2(-1.44269504 * interior.kernel_rate.x * r2);
    Kernels sum = Kernels(vec4(0.0), vec4(0.0), vec4(0.0));
    vec3 w;
#define GAUSSIAN(k) w = interior.kernel[k].rgb; sum.red += w.r * g; sum.green += w.g * g; sum.blue += w.b * g; g *= g;
    ALL_GAUSSIANS
#undef GAUSSIAN
    return sum;
}

/// From a group of points whose places vary by `variance` along each axis of the surface: to the second order, the
/// Gaussians' Laplacian there. Groups are seen neither edge-on nor face-on but in between: kSpread is 1 where they lie
/// along the way to them, 0 where they face it.
const float kSpread = 0.75;
Kernels kernels_of_group(vec4 r2, float variance) {
    vec4 rates = interior.kernel_rate.x * r2;
    vec4 g = exp2(-1.44269504 * rates), wide;
    float spread = 2.0 * interior.kernel_rate.x * variance;
    Kernels sum = Kernels(vec4(0.0), vec4(0.0), vec4(0.0));
    vec3 w;
#define GAUSSIAN(k) w = interior.kernel[k].rgb; wide = g + g * spread * (kSpread * rates - 1.0); \
    sum.red += w.r * wide; sum.green += w.g * wide; sum.blue += w.b * wide; \
    g *= g; rates += rates; spread += spread;
    ALL_GAUSSIANS
#undef GAUSSIAN
    return sum;
}

void add_flux(inout Exitances sum, Kernels kernels, vec4 r2, vec3 flux) {
    vec4 red = flux.r * kernels.red, green = flux.g * kernels.green, blue = flux.b * kernels.blue;
    sum.red += red;
    sum.green += green;
    sum.blue += blue;
    vec4 luminances = 0.2126 * red + 0.7152 * green + 0.0722 * blue;
    sum.deep += luminances * (1.0 - exp2(-interior.kernel_rate.y * sqrt(r2)));
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

vec4 squared_distances(Four four, vec3 place) {
    vec4 dx = four.x - place.x, dy = four.y - place.y, dz = four.z - place.z;
    return dx * dx + dy * dy + dz * dz;
}
void add_group(inout Four four, vec4 place, vec3 flux) {
    vec4 r2 = squared_distances(four, place.xyz);
    add_flux(four.sum, kernels_of_group(r2, place.w), r2, flux);
}
/// No point gathers from itself.
void add_point(inout Four four, uint point, vec3 place, vec3 flux) {
    vec4 r2 = squared_distances(four, place), other = mix(vec4(1.0), vec4(0.0), equal(four.points, uvec4(point)));
    Kernels kernels = kernels_of_point(r2);
    kernels = Kernels(kernels.red * other, kernels.green * other, kernels.blue * other);
    add_flux(four.sum, kernels, r2, flux);
}

uint node_in_lists(uint i) { return uint(texelFetch(lists, ivec2(i % 1024u, i / 1024u), 0).r); }

/// The next node with light from i on, or the list's last one; i is beyond it then.
uint next_lit(inout uint i, uint last, out vec3 flux) {
    uint node;
    do {
        node = node_in_lists(i++);
        flux = texelFetch(node_fluxes, node_texel(node), 0).rgb;
    } while (flux == vec3(0.0) && i < last);
    return node;
}

/// By the light that has entered everywhere but at the points themselves, not scaled there. Loops within loops, since
/// processors skip nothing but by a loop: the inner ones look for the next node with light. A list has its groups first,
/// and always points.
void gather(inout Four low, inout Four high) {
    uint i = list_begins[gl_WorkGroupID.x], last = list_begins[gl_WorkGroupID.x + 1u];
    vec3 flux;
    uint node = next_lit(i, last, flux);
    while (node >= point_count) {
        vec4 place = texelFetch(node_places, node_texel(node), 0);
        add_group(low, place, flux);
        add_group(high, place, flux);
        node = next_lit(i, last, flux);
    }
    do {
        vec3 place = texelFetch(node_places, node_texel(node), 0).xyz;
        add_point(low, node, place, flux);
        add_point(high, node, place, flux);
        if (i >= last) break;
        node = next_lit(i, last, flux);
    } while (true);
}
