// What a light sees of an object: where light enters.
#include "translucency/light_view.glsl"

in vec3 v_place;
in vec3 v_normal;
layout(location = 0) out vec4 entry;  // world normal; metres along the light's axis. A normal of 0: nothing there

void main() { entry = vec4(normalize(v_normal), light_place(v_place).z); }
