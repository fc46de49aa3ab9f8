// Places and normals of what is seen, in the body's space; w: packed normal plus 1. And what the kernel is multiplied by there.
#include "translucency/directions.glsl"

in vec3 v_place;
in vec3 v_normal;
in vec3 v_scale;
#ifdef PLACES
layout(location = 0) out vec4 place;
#endif
#ifdef SCALES
#ifdef PLACES
layout(location = 1) out vec4 scale;
#else
layout(location = 0) out vec4 scale;
#endif
#endif

void main() {
#ifdef PLACES
    place = vec4(v_place, packed_normal(v_normal) + 1.0);
#endif
#ifdef SCALES
    scale = vec4(v_scale, 1.0);
#endif
}
