// Deferred: light buffers times G-buffer, plus emission.
#include "render/shaders/compose.glsl"

in vec2 uv;
layout(location = 0) out vec4 radiance;

uniform sampler2D scene_depth;
uniform sampler2D gbuffer_normal;
uniform sampler2D gbuffer_base;
uniform sampler2D gbuffer_f0;
uniform sampler2D gbuffer_emissive;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    float depth = texelFetch(scene_depth, pixel, 0).x;
    radiance = vec4(0.0);
    if (depth <= 0.0) return;
    LitPoint point = decode_lit_point(texelFetch(gbuffer_normal, pixel, 0));
    StandardMaterial material =
        decode_material(texelFetch(gbuffer_base, pixel, 0), texelFetch(gbuffer_f0, pixel, 0));
    vec3 view = -eye_ray(uv);
    vec3 light = compose_radiance(pixel, material, point.normal, view, point.roughness);
    radiance = vec4(light + texelFetch(gbuffer_emissive, pixel, 0).rgb, 1.0);
}
