// Adds one light to a light map, or begins the map with it (BEGINS): what enters the skin at each texel's place. The
// smooth normal counts: detail is what light spreads over (Real-Time Rendering 14.6.2).
#include "skin/texture_space/texel.glsl"
#include "render/shaders/lights.glsl"
#include "seams/light_transmittance.glsl"

uniform uint light_index;
#include "skin/response.glsl"

uniform sampler2DArray skin_mirrors;  // oily_layer.h
uniform vec3 layers;                  // of the surface: SkinTables::layers()

/// Share of light at an angle that enters, over that of even light, as the shading model has it; by the nearest row of
/// roughness.
float entering(float cosine, float roughness) {
    ivec2 size = textureSize(skin_mirrors, 0).xy;
    vec2 place = standard_table_coordinate(cosine, roughness, float(size.x)) * vec2(size) - 0.5;
    ivec3 at = ivec3(clamp(ivec2(place.x, place.y + 0.5), ivec2(0), size - ivec2(2, 1)), int(layers.z));
    float low = texelFetch(skin_mirrors, at, 0).x, high = texelFetch(skin_mirrors, at + ivec3(1, 0, 0), 0).x;
    return mix(1.0, mix(low, high, place.x - float(at.x)), layers.y);
}

void main() {
    uint entry = list_entry();
    if (entry >= list_size) return;
    Texel texel = texel_at(entry);
    vec3 to_light;
    vec3 irradiance = light_irradiance(light_index, texel.place, to_light);
    float nol = dot(texel.normal, to_light);
    vec4 enters = imageLoad(finish, list_texel(entry));
    enters.rgb *= skin_response(nol, texel.curvature, layers.x) * entering(max(nol, 0.0), enters.w);
    vec3 light = irradiance * light_transmittance(light_index, texel.place, texel.normal) * enters.rgb;
#ifndef BEGINS
    light += imageLoad(map, texel.at).rgb;
#endif
    imageStore(map, texel.at, vec4(light, texel.chart));
}
