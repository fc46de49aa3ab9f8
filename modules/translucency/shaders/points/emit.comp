// What each group of points sends outside of what it has received so far. It is taken to leave where it entered, as a
// half-space gives it back, less what passes through the body there and leaves on its other side (as the technique thickness
// has it).
#define NODES_READ
#include "translucency/points/groups.glsl"

uniform sampler2D open_light;

void main() {
    uint group = gl_GlobalInvocationID.x;
    if (group >= point_count / kSightGroup) return;
    vec3 direct = vec3(0.0), open = vec3(0.0);
    float area = 1e-20, local = 1e-20;
    for (uint i = 0u; i < kSightGroup; ++i) {
        uint point = kSightGroup * group + i;
        direct += texelFetch(node_fluxes, node_texel(point), 0).rgb / max(scale_at(point), vec3(1e-6));
        open += texelFetch(open_light, node_texel(point), 0).rgb / float(kSightGroup);
        area += piece_at(point).area;
        local += texelFetch(pieces, node_texel(2u * point), 0).w;
    }
    direct /= area;
    if (interior.boundary.z == 0.0) direct *= half_space_returns();  // what the kernel leaves out
    vec3 stays = 1.0 / (1.0 + kernel_share_beyond(sqrt(area / local) * texelFetch(groups, node_texel(group), 0).z));
    vec3 back = mean_entering() * half_space_returns() + (1.0 - mean_entering());
    vec4 seen = imageLoad(group_light, node_texel(2u * group + 1u));
    // the other side is taken to have what is around
    vec3 exitance = stays * direct + back * mix(open, seen.rgb + seen.a * open, stays);
    imageStore(group_light, node_texel(2u * group), vec4(exitance, 0.0));
}
