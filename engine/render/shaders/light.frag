// Adds one light to the light buffers, at the pixels inside its volume.
#include "render/shaders/frame.glsl"
#include "render/shaders/lights.glsl"
#include "render/shaders/gbuffer.glsl"
#include "seams/shading_model.glsl"
#include "seams/light_transmittance.glsl"

uniform sampler2D scene_depth;
uniform sampler2D gbuffer_normal;
uniform uint light_index;  // what other providers of light transmittance know it by

layout(location = 0) out vec4 light_diffuse;
layout(location = 1) out vec4 light_specular_a;
layout(location = 2) out vec4 light_specular_b;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec2 uv = gl_FragCoord.xy / frame.size_time.xy;
    LitPoint lit = decode_lit_point(texelFetch(gbuffer_normal, pixel, 0));
    vec3 position = world_from_depth(uv, texelFetch(scene_depth, pixel, 0).x);

    ShadingPoint point = ShadingPoint(position, lit.normal, -eye_ray(uv), lit.roughness, lit.model, uv);
    LightSample light;
    light.light = light_index;
    light.unshadowed = light_irradiance(light_index, position, light.direction_to_light);
    LightReceiver receiver = light_receiver(lit.model, point, light.direction_to_light);
    light.transmittance = light_transmittance(light_index, receiver.position, receiver.normal);
    light.irradiance = light.unshadowed * light.transmittance;
    LightTerms terms = shade(lit.model, point, light);
    if (!light_has_highlight(light_index)) terms.specular_a = terms.specular_b = vec3(0.0);
    light_diffuse = vec4(terms.diffuse, 0.0);
    light_specular_a = vec4(terms.specular_a, 0.0);
    light_specular_b = vec4(terms.specular_b, 0.0);
}
