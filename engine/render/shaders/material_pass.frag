// Light pre-pass: a surface's material applied to the light that its pixel received.
#include "render/shaders/compose.glsl"
#include "render/shaders/material.glsl"

layout(location = 0) out vec4 radiance;

void main() {
    MaterialPoint point = material_at();
    vec3 view = normalize(frame.eye_near.xyz - v_position);
    vec3 light = compose_radiance(ivec2(gl_FragCoord.xy), point.standard, point.normal, view, point.roughness);
    radiance = vec4(light + point.emissive, 1.0);
}
