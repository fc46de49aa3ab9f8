// Numbers the pixels where an object is seen, with what its kernel is multiplied by there.
#include "render/shaders/frame.glsl"

in vec3 v_scale;
in vec3 v_turn;
uniform sampler2D scene_depth;
uniform float number;
layout(location = 0) out vec4 mark;
layout(location = 1) out vec4 turn;

void main() {
    float depth = texelFetch(scene_depth, ivec2(gl_FragCoord.xy), 0).x;
    // another surface is in front
    if (depth <= 0.0 || abs(view_depth(depth) * gl_FragCoord.w - 1.0) > 5e-4) discard;
    mark = vec4(v_scale, number);
    turn = vec4(v_turn, 0.0);
}
