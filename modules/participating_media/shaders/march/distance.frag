// How far each marched pixel's ray goes, before the lights add to it.
#include "render/shaders/frame.glsl"

uniform sampler2D scene_depth;
uniform int pixel_step;  // full-resolution pixels from one marched pixel to the next
uniform float farthest;  // metres; rays that hit nothing end here

out vec4 in_scatter;  // rgb radiance, a metres marched

void main() {
    ivec2 pixel = min(ivec2(gl_FragCoord.xy) * pixel_step, ivec2(frame.size_time.xy) - 1);
    float depth = texelFetch(scene_depth, pixel, 0).r;
    vec2 uv = (vec2(pixel) + 0.5) / frame.size_time.xy;
    in_scatter = vec4(0.0, 0.0, 0.0, depth > 0.0 ? eye_distance(uv, depth) : farthest);
}
