// Begins a light map with what enters of the light from all around.
#include "skin/texture_space/texel.glsl"
#include "seams/indirect_light.glsl"

layout(r32f) readonly uniform image2D occlusion;

void main() {
    uint entry = list_entry();
    if (entry >= list_size) return;
    Texel texel = texel_at(entry);
#ifdef DARK
    vec3 light = vec3(0.0);
#else
    vec3 light = indirect_light(texel.place, texel.normal, texel.normal, 1.0).irradiance * imageLoad(occlusion, list_texel(entry)).x * imageLoad(finish, list_texel(entry)).rgb;
#endif
    imageStore(map, texel.at, vec4(light, texel.chart));
}
