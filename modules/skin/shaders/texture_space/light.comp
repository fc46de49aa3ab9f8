// Adds one light to a light map: what enters the skin at each texel's place. The smooth normal counts: detail is what
// light spreads over (Real-Time Rendering 14.6.2).
#include "skin/texture_space/texel.glsl"
#include "render/shaders/lights.glsl"
#include "seams/light_transmittance.glsl"

uniform uint light_index;
uniform sampler2D skin_entering;

void main() {
    uint entry = list_entry();
    if (entry >= list_size) return;
    Texel texel = texel_at(entry);
    vec3 to_light;
    vec3 irradiance = light_irradiance(light_index, texel.place, to_light);
    float nol = max(dot(texel.normal, to_light), 0.0);
    vec4 enters = imageLoad(finish, list_texel(entry));
    vec2 lookup = standard_table_coordinate(nol, enters.w, float(textureSize(skin_entering, 0).x));
    enters.rgb *= nol * textureLod(skin_entering, lookup, 0.0).x;
    vec3 light = irradiance * light_transmittance(light_index, texel.place, texel.normal) * enters.rgb;
    imageStore(map, texel.at, vec4(imageLoad(map, texel.at).rgb + light, texel.chart));
}
