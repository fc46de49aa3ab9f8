// A unit of light a unit of area everywhere, for balance.comp. BEGIN: all scales become 1.
#define SCALES_WRITTEN
#include "translucency/points/cloud.glsl"

void main() {
    uint point = gl_GlobalInvocationID.x;
    if (point >= point_count) return;
#ifdef BEGIN
    vec3 scale = vec3(1.0);
    imageStore(point_scales, node_texel(point), vec4(scale, 0.0));
#else
    vec3 scale = scale_at(point);
#endif
    Piece piece = piece_at(point);
    imageStore(node_places, node_texel(point), vec4(piece.place, 0.0));
    imageStore(node_fluxes, node_texel(point), vec4(scale * piece.area, 0.0));
}
