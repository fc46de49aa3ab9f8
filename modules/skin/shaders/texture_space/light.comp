// Adds one light to a light map: what enters the skin at each texel's place. The smooth normal counts: detail is what
// light spreads over (Real-Time Rendering 14.6.2).
#include "skin/texture_space/texel.glsl"
#include "render/shaders/lights.glsl"
#include "seams/light_transmittance.glsl"

uniform uint light_index;
uniform sampler2D skin_entering;

/// Share of light at an angle that enters, over that of even light; by the nearest row of roughness.
float entering(float cosine, float roughness) {
    ivec2 size = textureSize(skin_entering, 0);
    vec2 place = standard_table_coordinate(cosine, roughness, float(size.x)) * vec2(size) - 0.5;
    ivec2 at = clamp(ivec2(place.x, place.y + 0.5), ivec2(0), size - ivec2(2, 1));
    return mix(texelFetch(skin_entering, at, 0).x, texelFetch(skin_entering, at + ivec2(1, 0), 0).x, place.x - float(at.x));
}

void main() {
    uint entry = list_entry();
    if (entry >= list_size) return;
    Texel texel = texel_at(entry);
    vec3 to_light;
    vec3 irradiance = light_irradiance(light_index, texel.place, to_light);
    float nol = max(dot(texel.normal, to_light), 0.0);
    vec4 enters = imageLoad(finish, list_texel(entry));
    enters.rgb *= nol * entering(nol, enters.w);
    vec3 light = irradiance * light_transmittance(light_index, texel.place, texel.normal) * enters.rgb;
    imageStore(map, texel.at, vec4(imageLoad(map, texel.at).rgb + light, texel.chart));
}
