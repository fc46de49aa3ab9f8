// Light from all around, as it is where light that leaves a pixel has entered.
#include "render/shaders/frame.glsl"
#include "render/shaders/gbuffer.glsl"
#include "seams/indirect_light.glsl"

in vec3 v_own;
in vec3 v_others;
in vec3 v_sizes;
uniform sampler2D scene_depth;
uniform sampler2D gbuffer_normal;
layout(location = 0) out vec4 around;

vec3 irradiance(vec3 place, vec3 normal) { return indirect_light(place, normal, normal, 1.0).irradiance; }

/// Mean of the irradiance where light that leaves here has entered, a channel each, by the mean normal there. In three
/// parts: the same for all normals, linear in the normal, and the rest, which a mean of normals that differ has less of.
vec3 mean_irradiance(vec3 place, vec3 normal) {
    const vec3 x = vec3(1.0, 0.0, 0.0), y = x.yxz, z = x.yzx;
    vec3 east = irradiance(place, x), west = irradiance(place, -x), up = irradiance(place, y), down = irradiance(place, -y),
         south = irradiance(place, z), north = irradiance(place, -z);
    vec3 even = (east + west + up + down + south + north) / 6.0;
    mat3 slope = 0.5 * mat3(east - west, up - down, south - north);
    vec3 rest = irradiance(place, normal) - even - slope * normal;
    vec3 linear = v_own * (slope * normal) + v_sizes * (slope * v_others);
    vec3 alike = v_own + v_sizes * length(v_others);
    return max(even + linear + rest * alike * alike, vec3(0.0));
}

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    float depth = texelFetch(scene_depth, pixel, 0).x;
    // another surface is in front
    if (depth <= 0.0 || abs(view_depth(depth) * gl_FragCoord.w - 1.0) > 5e-4) discard;
    vec3 normal = decode_lit_point(texelFetch(gbuffer_normal, pixel, 0)).normal;
    around = vec4(mean_irradiance(world_from_depth(gl_FragCoord.xy / frame.size_time.xy, depth), normal), 1.0);
}
