// What passes after the light pass need to know of skin at a pixel (pixels/surface_pixels_pass.h).
#include "skin/texture_space/slot.glsl"

in vec2 v_uv;
layout(location = 0) out vec4 skin_pixels;

#ifdef COLOURED
uniform vec3 base_colour;
uniform float pre_scatter;
SLOT(base_colour_map)
#endif
#ifdef THICKNESS_MAP
uniform float map_m;  // metres that 1 of the map stands for
SLOT(thickness_map)
#endif
#ifdef VERTEX_THICKNESS
in float v_thickness;
#endif

void main() {
    skin_pixels = vec4(1.0, 1.0, 1.0, -1.0);
#ifdef COLOURED
    vec3 colour = base_colour * texture(base_colour_map, base_colour_map_place(v_uv)).rgb;
    skin_pixels.rgb = pow(max(colour, vec3(kLeastColour)), vec3(pre_scatter));
#endif
#ifdef THICKNESS_MAP
    skin_pixels.a = map_m * texture(thickness_map, thickness_map_place(v_uv)).r;
#endif
#ifdef VERTEX_THICKNESS
    skin_pixels.a = v_thickness;
#endif
}
