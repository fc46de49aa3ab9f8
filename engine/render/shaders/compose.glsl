// Light buffers times material: the last step of both paths.
#include "render/shaders/frame.glsl"
#include "render/shaders/gbuffer.glsl"
#include "render/shaders/specular_table.glsl"

uniform sampler2D light_diffuse;
uniform sampler2D light_specular_a;
uniform sampler2D light_specular_b;

// Radiance toward the eye from the lights gathered at `pixel`, without emission.
vec3 compose_radiance(ivec2 pixel, StandardMaterial material, vec3 normal, vec3 view, float roughness) {
    LightTerms terms;
    terms.diffuse = texelFetch(light_diffuse, pixel, 0).rgb;
    terms.specular_a = texelFetch(light_specular_a, pixel, 0).rgb;
    terms.specular_b = texelFetch(light_specular_b, pixel, 0).rgb;
    return standard_compose(material, specular_table_at(standard_nov(normal, view), roughness), terms);
}
