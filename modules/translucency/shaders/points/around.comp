// Adds to the points' light what comes from no light: see.comp.
#include "translucency/points/cloud.glsl"

layout(rgba32f) readonly uniform image2D point_light;
layout(rgba32f) uniform image2D open_light;  // afterwards: of the point's own flux what pixels do not know of, lm

void main() {
    uint point = gl_GlobalInvocationID.x;
    if (point >= point_count) return;
    Piece piece = piece_at(point);
    vec3 irradiance = imageLoad(point_light, node_texel(2u * point + 1u)).rgb;
    vec3 unknown = irradiance - imageLoad(open_light, node_texel(point)).rgb;
    vec3 leaves = scale_at(point) * mean_leaving() * enters_to_wander(piece.place) * (mean_entering() * piece.area);
    imageStore(open_light, node_texel(point), vec4(unknown * leaves, 0.0));
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
