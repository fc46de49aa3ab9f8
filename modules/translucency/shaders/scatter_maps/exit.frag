// Where a light's rays leave the solid and enter it last: blended by the maximum.
#include "translucency/light_view.glsl"

in vec3 v_place;
layout(location = 0) out vec4 depths;  // minus the nearest exit, the farthest, the farthest entry

void main() {
    float z = light_place(v_place).z - view.window.w;
    depths = gl_FrontFacing ? vec4(-1e30, -1e30, z, 0.0) : vec4(-z, z, -1e30, 0.0);
}
