// Begins the points' light: none has entered, and what is all around is known.
#include "translucency/points/groups.glsl"
#include "render/shaders/frame.glsl"
#include "seams/indirect_light.glsl"

layout(rgba32f) writeonly uniform image2D open_light;   // irradiance from all around as if nothing hid it, lux

void main() {
    uint point = gl_GlobalInvocationID.x;
    if (point >= point_count) return;
    Piece piece = piece_at(point);
    vec4 open = vec4(indirect_light(piece.place, piece.normal, piece.normal, 1.0).irradiance, 0.0);
    imageStore(open_light, node_texel(point), open);
    // at first each group sees what is around everywhere
    if (point < point_count / kSightGroup) imageStore(group_light, node_texel(2u * point + 1u), vec4(0.0, 0.0, 0.0, 1.0));
    imageStore(node_fluxes, node_texel(point), vec4(0.0));
    imageStore(node_places, node_texel(point), vec4(piece.place, 0.0));
#ifdef DIRECTIONS
    imageStore(node_directions, node_texel(point), vec4(-piece.normal, packed_normal(piece.normal)));
#endif
}
