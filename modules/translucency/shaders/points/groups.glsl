// Groups of points that see parts of their own body (point_cloud.h, look_around).
#include "translucency/points/cloud.glsl"

const uint kSightGroup = 8u;  // points
const float kSightRays = 16.0 * float(kSightGroup);
uniform sampler2D groups;  // x, y its first sight and the next group's; z metres of the body below, in the mesh's own space
layout(rgba32f) uniform image2D group_light;  // two texels a group: exitance (emit.comp); what it sees of it, share of open (see.comp)
