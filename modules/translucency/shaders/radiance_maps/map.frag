// Places and normals of what is seen, in the body's space; w: packed normal plus 1. And what vertices have.
#include "translucency/directions.glsl"

in vec3 v_place;
in vec3 v_normal;
in vec3 v_colour;
layout(location = 0) out vec4 place;
layout(location = 1) out vec4 colour;

void main() {
    place = vec4(v_place, packed_normal(v_normal) + 1.0);
    colour = vec4(v_colour, 1.0);
}
