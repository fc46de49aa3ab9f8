// What each point receives of all that is no light: what is around, where the body does not hide it, and light that leaves
// other points and meets the body again, once more in every round. That is taken to leave where it entered, as a half-space
// gives it back, less what passes through the body there and leaves on its other side (as the technique thickness has it).
#define NODES_READ
#include "translucency/points/cloud.glsl"

uniform sampler2D open_light;
layout(rgba32f) uniform image2D point_light;  // two texels a point, for rounds in turn: irradiance, lux
uniform sampler2D depths;  // of the body below each point, in the mesh's own space
uniform uint round;

/// Of a point's light what leaves it outside again, a unit of area.
vec3 exitance_of(uint point, vec3 returns, vec3 back, uint before) {
    float area = max(piece_at(point).area, 1e-20);
    float metres = sqrt(area / texelFetch(pieces, node_texel(2u * point), 0).w);
    float depth = metres * texelFetch(depths, ivec2(point % 1024u, point / 1024u), 0).r;
    vec3 stays = 1.0 / (1.0 + kernel_share_beyond(depth));
    vec3 direct = texelFetch(node_fluxes, node_texel(point), 0).rgb / (max(scale_at(point), vec3(1e-6)) * area);
    vec3 seen = imageLoad(point_light, node_texel(2u * point + before)).rgb;
    // the other side is taken to have what is around
    return returns * stays * direct + back * mix(texelFetch(open_light, node_texel(point), 0).rgb, seen, stays);
}

void main() {
    uint point = gl_GlobalInvocationID.x;
    if (point >= point_count) return;
    uint first = sights_begin(point), last = sights_begin(point + 1u), before = round & 1u;
    vec3 returns = interior.boundary.z > 0.0 ? vec3(1.0) : interior.base_entering.rgb;  // what the kernel leaves out
    vec3 back = mean_entering() * half_space_returns() + (1.0 - mean_entering());
    vec3 sum = vec3(0.0);
    uint i = first;
    if (i < last) {
        do {
            uint other = uint(texelFetch(sights, ivec2(i % 1024u, i / 1024u), 0).r);
            sum += exitance_of(other, returns, back, before);
        } while (++i < last);
    }
    float open = 1.0 - float(last - first) / float(kSightRays);
    vec3 irradiance = open * texelFetch(open_light, node_texel(point), 0).rgb + sum / float(kSightRays);
    imageStore(point_light, node_texel(2u * point + 1u - before), vec4(irradiance, 0.0));
}
