// What each point sends outside of what it has received so far. It is taken to leave where it entered, as a half-space gives
// it back, less what passes through the body there and leaves on its other side (as the technique thickness has it).
#define NODES_READ
#include "translucency/points/cloud.glsl"

uniform sampler2D open_light;
uniform sampler2D depths;  // of the body below each point, in the mesh's own space
layout(rgba32f) uniform image2D point_light;  // of two texels a point the first: exitance, lm/m2; the second: see.comp

void main() {
    uint point = gl_GlobalInvocationID.x;
    if (point >= point_count) return;
    float area = max(piece_at(point).area, 1e-20);
    float metres = sqrt(area / texelFetch(pieces, node_texel(2u * point), 0).w);
    float depth = metres * texelFetch(depths, ivec2(point % 1024u, point / 1024u), 0).r;
    vec3 stays = 1.0 / (1.0 + kernel_share_beyond(depth));
    vec3 direct = texelFetch(node_fluxes, node_texel(point), 0).rgb / (max(scale_at(point), vec3(1e-6)) * area);
    if (interior.boundary.z == 0.0) direct *= half_space_returns();  // what the kernel leaves out
    vec3 back = mean_entering() * half_space_returns() + (1.0 - mean_entering());
    vec3 seen = imageLoad(point_light, node_texel(2u * point + 1u)).rgb;
    // the other side is taken to have what is around
    vec3 exitance = stays * direct + back * mix(texelFetch(open_light, node_texel(point), 0).rgb, seen, stays);
    imageStore(point_light, node_texel(2u * point), vec4(exitance, 0.0));
}
