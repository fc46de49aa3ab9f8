// Creates the light buffers with the light that comes from no light source.
#include "render/shaders/frame.glsl"
#include "render/shaders/gbuffer.glsl"
#include "render/shaders/specular_table.glsl"
#include "seams/indirect_light.glsl"

uniform sampler2D scene_depth;
uniform sampler2D gbuffer_normal;

layout(location = 0) out vec4 light_diffuse;
layout(location = 1) out vec4 light_specular_a;
layout(location = 2) out vec4 light_specular_b;

// How much of the specular lobe is open where `occlusion` of the hemisphere is (Lagarde & de Rousiers 2014).
float specular_occlusion(float nov, float occlusion, float roughness) {
    return clamp(pow(nov + occlusion, exp2(-16.0 * roughness - 1.0)) - 1.0 + occlusion, 0.0, 1.0);
}

void main() {
    light_diffuse = light_specular_a = light_specular_b = vec4(0.0);
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    float depth = texelFetch(scene_depth, pixel, 0).x;
    if (depth <= 0.0) return;
    LitPoint point = decode_lit_point(texelFetch(gbuffer_normal, pixel, 0));
    vec2 uv = gl_FragCoord.xy / frame.size_time.xy;
    vec3 position = world_from_depth(uv, depth);
    vec3 view = -eye_ray(uv);
    float nov = standard_nov(point.normal, view);
    IndirectLight light = indirect_light(position, point.normal, view, point.roughness);
    LightTerms terms = standard_environment(light.irradiance * point.occlusion,
                                            light.specular * specular_occlusion(nov, point.occlusion, point.roughness),
                                            specular_table_at(nov, point.roughness));
    light_diffuse = vec4(terms.diffuse, 0.0);
    light_specular_a = vec4(terms.specular_a, 0.0);
    light_specular_b = vec4(terms.specular_b, 0.0);
}
