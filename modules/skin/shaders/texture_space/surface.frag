// Puts light that has spread in a map in place of what arrives at the pixels. COLOURED: colour to a power counted where it
// entered; ROOT: the power is a half. LIMB: what leaves goes by the angle.
//
// The triangles are small, so that most of what is shaded is not seen: what is not needed is not compiled.
#include "render/shaders/frame.glsl"
#include "render/shaders/gbuffer.glsl"
#include "skin/texture_space/slot.glsl"

in vec2 v_uv;
layout(location = 0) out vec4 light_diffuse;

uniform sampler2D map;
uniform vec4 map_from_uv;  // scale, offset: to 0..1 over the map
#ifdef LIMB
uniform sampler2D gbuffer_surface;
uniform vec3 limb;  // physics/profile_corrections.h
#endif
#ifdef COLOURED
uniform vec3 base_colour;
uniform float pre_scatter;
SLOT(base_colour_map)
#endif

void main() {
    vec3 light = textureLod(map, v_uv * map_from_uv.xy + map_from_uv.zw, 0.0).rgb;
#ifdef COLOURED
    vec3 colour = base_colour * texture(base_colour_map, base_colour_map_place(v_uv)).rgb;
    colour = max(colour, vec3(kLeastColour));
#ifdef ROOT
    light *= inversesqrt(colour);
#else
    light *= pow(colour, vec3(-pre_scatter));
#endif
#endif
#ifdef LIMB
    vec3 normal = decode_surface_point(texelFetch(gbuffer_surface, ivec2(gl_FragCoord.xy), 0)).normal;
    float cosine = max(dot(normal, -eye_ray(gl_FragCoord.xy / frame.size_time.xy)), 0.0);
    light *= 1.0 + limb * (0.5 - cosine * cosine);
#endif
    light_diffuse = vec4(light, 0.0);
}
