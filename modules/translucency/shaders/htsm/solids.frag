// Numbers the pixels where a solid is seen: the light passes then need not draw its triangles, which may be as small as
// pixels and would pay for their neighbours.
#include "render/shaders/frame.glsl"

uniform sampler2D scene_depth;
uniform float number;
layout(location = 0) out float solid_number;

void main() {
    float depth = texelFetch(scene_depth, ivec2(gl_FragCoord.xy), 0).x;
    // another surface is in front
    if (depth <= 0.0 || abs(view_depth(depth) * gl_FragCoord.w - 1.0) > 5e-4) discard;
    solid_number = number;
}
