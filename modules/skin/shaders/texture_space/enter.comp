// Adds light from all around to a light map, and colours all of it as the skin does where light enters.
#include "skin/texture_space/texel.glsl"
#include "seams/indirect_light.glsl"

layout(r32f) readonly uniform image2D occlusion;
uniform float keeps;  // 0: the map begins here

void main() {
    uint entry = gl_GlobalInvocationID.x;
    if (entry >= list_size) return;
    Texel texel = texel_at(entry);
    vec3 light = indirect_light(texel.place, texel.normal, texel.normal, 1.0).irradiance * imageLoad(occlusion, list_texel(entry)).x;
    if (keeps != 0.0) light += imageLoad(map, texel.at).rgb;
    light *= imageLoad(finish, list_texel(entry)).rgb;
    imageStore(map, texel.at, vec4(light, mix(texel.chart, 1.0, whole)));
}
