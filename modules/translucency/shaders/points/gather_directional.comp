// As gather.comp, with the directional dipole: light leaves by where it entered, along which way, and both normals. A node
// has the mean way: the model is linear in it, but for how far away it takes its real source to be.
#define NODES_READ
#include "translucency/points/cloud.glsl"
#include "translucency/points/store.glsl"
#include "physics/bssrdf.glsl"

uniform sampler2D lists;  // nodes' numbers
layout(std430) readonly buffer ListBegins { uint list_begins[]; };
uniform float piece_radius;  // metres

vec3 exitance_from(Diffusion m, uint node, vec3 place, vec3 normal) {
    vec3 flux = texelFetch(node_fluxes, node_texel(node), 0).rgb;
    if (flux == vec3(0.0)) return vec3(0.0);
    vec3 x = place - texelFetch(node_places, node_texel(node), 0).xyz;
    float r = length(x);
    // pieces that touch are no points to one another
    float apart = smoothstep(2.0 * piece_radius, 4.0 * piece_radius, r);
    vec3 kernel = (1.0 - apart) * kernel_at(r * r);
    if (apart > 0.0) {
        vec4 direction = texelFetch(node_directions, node_texel(node), 0);
        kernel += apart * interior.published.rgb *
                  directional_dipole(m, x, normalize(direction.xyz), unpacked_normal(direction.w), normal);
    }
    return flux * kernel;
}

void main() {
    uint point = gl_GlobalInvocationID.x;
    Piece piece = piece_at(point);
    Diffusion m = make_diffusion(interior.sigma_s_reduced.rgb, interior.sigma_a.rgb, 0.0, interior_eta());
    uint last = list_begins[gl_WorkGroupID.x + 1u];
    vec3 sum = vec3(0.0);
    for (uint i = list_begins[gl_WorkGroupID.x]; i < last; ++i) {
        uint node = uint(texelFetch(lists, ivec2(i % 1024u, i / 1024u), 0).r);
        if (node != point) sum += exitance_from(m, node, piece.place, piece.normal);
    }
    store(point, vec4(sum, 0.0));
}
