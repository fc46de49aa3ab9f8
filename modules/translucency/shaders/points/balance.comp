// Scales the kernel at both ends so that each point sends out all of its light, and receives as much: what leaves is what
// the half-space says, whatever the shape. A kernel of flat ground alone loses what would leave beyond the solid's end.
// Symmetric, so reciprocity stays (Sinkhorn & Knopp's balancing of a symmetric matrix; the root is Knight, Ruiz & Ucar's).
//
// BEGIN: all scales are 1. FLUX: a unit of light a unit of area everywhere. Else: the step.
#include "translucency/points/gather.glsl"

#ifdef BEGIN
void main() {
    uint point = gl_GlobalInvocationID.x;
    if (point < point_count) point_scales[point] = vec4(1.0);
}
#elif defined(FLUX)
void main() {
    uint point = gl_GlobalInvocationID.x;
    if (point >= point_count) return;
    Piece piece = piece_at(point);
    node_places[point] = vec4(piece.place, 0.0);
    node_fluxes[point] = vec4(point_scales[point].rgb * piece.area, 0.0);
}
#else
void main() {
    uint point = gl_WorkGroupID.x * gl_WorkGroupSize.x + gl_LocalInvocationID.x;
    Piece piece = piece_at(point);
    vec3 scale = point_scales[point].rgb;
    vec3 sum = gathered(gl_WorkGroupID.x, point, piece.place).rgb + scale * kernel_at(0.0).rgb * piece.area;
    point_scales[point] = vec4(sqrt(scale / max(sum, vec3(1e-20))), 0.0);
}
#endif
