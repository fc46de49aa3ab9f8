// Puts light that has spread in a map in place of what arrives at the pixels. COLOURED: colour to a power counted where it
// entered; ROOT: the power is a half.
#include "render/shaders/frame.glsl"
#include "render/shaders/gbuffer.glsl"
#include "skin/surfaces.glsl"
#include "skin/texture_space/slot.glsl"

in vec2 v_uv;
layout(location = 0) out vec4 light_diffuse;

uniform sampler2D scene_depth;
uniform sampler2D gbuffer_surface;
uniform sampler2D map;
uniform vec4 map_from_uv;  // scale, offset: to 0..1 over the map
uniform float number;      // of the surface
#ifdef COLOURED
uniform vec3 base_colour;
uniform float pre_scatter;
SLOT(base_colour_map)
#endif
void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    // another surface, or another part of this one, is in front
    if (surface_number(texelFetch(gbuffer_surface, pixel, 0)) != number) discard;
    float depth = texelFetch(scene_depth, pixel, 0).x;
    if (depth <= 0.0 || abs(view_depth(depth) * gl_FragCoord.w - 1.0) > 5e-4) discard;
    vec3 light = textureLod(map, v_uv * map_from_uv.xy + map_from_uv.zw, 0.0).rgb;
#ifdef COLOURED
    vec3 colour = base_colour;
    if (base_colour_map_share > 0.0) colour *= texture(base_colour_map, base_colour_map_place(v_uv)).rgb;
    colour = max(colour, vec3(kLeastColour));
#ifdef ROOT
    light *= inversesqrt(colour);
#else
    light *= pow(colour, vec3(-pre_scatter));
#endif
#endif
    vec3 normal = decode_surface_point(texelFetch(gbuffer_surface, pixel, 0)).normal;
    float cosine = max(dot(normal, -eye_ray(gl_FragCoord.xy / frame.size_time.xy)), 0.0);
    light_diffuse = vec4(light * skin_limb(skin_surface(number), cosine), 0.0);
}
