// Begins the points' light with what comes from all around.
#include "translucency/points/cloud.glsl"
#include "render/shaders/frame.glsl"
#include "seams/indirect_light.glsl"

void main() {
    uint point = gl_GlobalInvocationID.x;
    if (point >= point_count) return;
    Piece piece = piece_at(point);
    vec3 irradiance = indirect_light(piece.place, piece.normal, piece.normal, 1.0).irradiance;
    float share = mean_entering();
    vec3 leaving = irradiance * scale_at(point) * mean_leaving() * enters_to_wander(piece.place);
    imageStore(node_fluxes, node_texel(point), vec4(leaving * (share * piece.area), luminance_rec709(irradiance)));
#ifdef DIRECTIONS
    imageStore(node_directions, node_texel(point), vec4(-piece.normal, packed_normal(piece.normal)));
#endif
    imageStore(node_places, node_texel(point), vec4(piece.place, share * luminance_rec709(irradiance)));
}
