// Turns the irradiance of a translucent surface's pixels into what makes the base look as the light that leaves does:
// the share of the pixel's own light that leaves where it entered, and what the points gathered.
#include "render/shaders/frame.glsl"
#include "render/shaders/gbuffer.glsl"
#include "translucency/interior.glsl"

in vec4 v_others;
in vec3 v_own;
layout(location = 0, index = 0) out vec4 gathered;
layout(location = 0, index = 1) out vec4 kept;

uniform sampler2D scene_depth;
uniform sampler2D gbuffer_normal;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    float depth = texelFetch(scene_depth, pixel, 0).x;
    // another surface is in front
    if (depth <= 0.0 || abs(view_depth(depth) * gl_FragCoord.w - 1.0) > 5e-4) discard;
    vec3 normal = decode_lit_point(texelFetch(gbuffer_normal, pixel, 0)).normal;
    vec2 uv = gl_FragCoord.xy / frame.size_time.xy;
    float cosine = standard_nov(normal, -eye_ray(uv));
    // The compose pass multiplies by the base and by what the mirror lets through, which is how light passes outward.
    vec3 scale = 1.0 / (max(interior.base_entering.rgb, vec3(1e-4)) * mean_entering());
    vec3 near = near_pattern(cosine);
    gathered = vec4(scale * mix(near, deep_pattern(cosine), v_others.a) * v_others.rgb, 0.0);
    kept = vec4(scale * near * v_own * enters_to_wander(world_from_depth(uv, depth)), 1.0);
}
