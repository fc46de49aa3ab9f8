// Adds to the points' light what comes from no light: what is around, where the body does not hide it, and what the body
// sends to itself (see.comp).
#include "translucency/points/groups.glsl"

uniform sampler2D group_blends;  // a point's four groups: 256 times the number, and the weight
layout(rgba32f) uniform image2D open_light;  // afterwards: of the point's own flux what pixels do not know of, lm
uniform int sees;

/// What a point sees of its body, lux, and the share of what is around.
vec4 seen_by(uint point) {
    if (sees == 0) return vec4(0.0, 0.0, 0.0, 1.0);
    uvec4 both = uvec4(texelFetch(group_blends, node_texel(point), 0));
    vec4 weights = vec4(both & 255u), sum = vec4(0.0);
    for (uint i = 0u; i < 4u; ++i) sum += weights[i] * imageLoad(group_light, node_texel(2u * (both[i] >> 8u) + 1u));
    return sum / max(dot(weights, vec4(1.0)), 1e-6);
}

void main() {
    uint point = gl_GlobalInvocationID.x;
    if (point >= point_count) return;
    Piece piece = piece_at(point);
    vec3 open = imageLoad(open_light, node_texel(point)).rgb;
    vec4 seen = seen_by(point);
    vec3 irradiance = seen.rgb + seen.a * open;
    vec3 leaves = scale_at(point) * mean_leaving() * enters_to_wander(piece.place) * (mean_entering() * piece.area);
    imageStore(open_light, node_texel(point), vec4((irradiance - open) * leaves, 0.0));
    float arrives = luminance_rec709(irradiance), entered = mean_entering() * arrives;
    if (arrives <= 0.0) return;
    vec4 place = imageLoad(node_places, node_texel(point));
    float share = entered / max(place.w + entered, 1e-30);
    imageStore(node_fluxes, node_texel(point), imageLoad(node_fluxes, node_texel(point)) + vec4(irradiance * leaves, arrives));
    imageStore(node_places, node_texel(point), vec4(mix(place.xyz, piece.place, share), place.w + entered));
#ifdef DIRECTIONS
    vec4 direction = imageLoad(node_directions, node_texel(point));
    direction.xyz = mix(direction.xyz, -piece.normal, share);
    imageStore(node_directions, node_texel(point), direction);
#endif
}
