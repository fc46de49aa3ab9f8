// Every other pixel of a solid: of four that are looked at together one where it is seen.
#include "render/shaders/frame.glsl"

uniform sampler2D blur_places;  // depth, which of the four; 0: none

ivec2 pixel_of(ivec2 texel, float which) { return 2 * texel + ivec2(int(which) & 1, int(which) >> 1); }
vec3 place_of(ivec2 texel, vec2 found) {
    return world_from_depth((vec2(pixel_of(texel, found.y)) + 0.5) / frame.size_time.xy, found.x);
}
