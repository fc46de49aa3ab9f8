// Adds one light to a light map: what enters the skin at each texel's place. The smooth normal counts: detail is what
// light spreads over (Real-Time Rendering 14.6.2).
#include "skin/texture_space/texel.glsl"
#include "render/shaders/lights.glsl"
#include "seams/light_transmittance.glsl"

uniform uint light_index;
uniform float keeps;  // 0: the map begins here
uniform sampler2D skin_entering;

void main() {
    uint entry = gl_GlobalInvocationID.x;
    if (entry >= list_size) return;
    Texel texel = texel_at(entry);
    vec3 to_light;
    vec3 irradiance = light_irradiance(light_index, texel.place, to_light);
    float nol = dot(texel.normal, to_light);
    vec3 light = vec3(0.0);
    if (nol > 0.0 && irradiance != vec3(0.0)) {
        float roughness = imageLoad(finish, list_texel(entry)).w;
        float size = float(textureSize(skin_entering, 0).x);
        float enters = textureLod(skin_entering, standard_table_coordinate(nol, roughness, size), 0.0).x;
        light = irradiance * light_transmittance(light_index, texel.place, texel.normal) * (nol * enters);
    }
    if (keeps != 0.0) light += imageLoad(map, texel.at).rgb;
    imageStore(map, texel.at, vec4(light, mix(texel.chart, 1.0, whole)));
}
