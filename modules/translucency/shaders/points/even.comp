// A unit of light a unit of area everywhere, for balance.comp. BEGIN: all scales become 1.
#include "translucency/points/cloud.glsl"

void main() {
    uint point = gl_GlobalInvocationID.x;
    if (point >= point_count) return;
#ifdef BEGIN
    point_scales[point] = vec4(1.0);
#endif
    Piece piece = piece_at(point);
    imageStore(node_places, node_texel(point), vec4(piece.place, 0.0));
    imageStore(node_fluxes, node_texel(point), vec4(point_scales[point].rgb * piece.area, 0.0));
}
