// A light's map of a solid (scatter_maps/scatter_map.h).
#include "translucency/light_view.glsl"

uniform sampler2D entry_light;  // lux across the light's way that have entered; 1
uniform sampler2D entry_way;    // direction inside, as long as the refracted way for a metre of the straight; depth
uniform sampler2D entry_flux;   // what leaves of it scattered more than once, before it is spread; luminance times depth
uniform sampler2D exits;

/// Where the light's ray has left the solid for good: nowhere if it comes in once more (the mesh has a hole).
float last_exit(vec2 uv) {
    vec4 leaves = textureGather(exits, uv, 1), enters = textureGather(exits, uv, 2);
    leaves = mix(leaves, vec4(1e30), greaterThan(enters, leaves));
    return max(max(leaves.x, leaves.y), max(leaves.z, leaves.w));
}
