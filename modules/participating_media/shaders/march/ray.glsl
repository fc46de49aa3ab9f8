// Which ray a marched pixel stands for, and how far it goes.
#include "render/shaders/frame.glsl"

uniform sampler2D scene_depth;
uniform int pixel_step;  // full-resolution pixels from one marched pixel to the next
uniform float farthest;  // metres; rays that hit nothing end here

/// The full-resolution pixel in the middle of those that a marched pixel stands for.
ivec2 marched_pixel(ivec2 marched) {
    return min(marched * pixel_step + pixel_step / 2, ivec2(frame.size_time.xy) - 1);
}

vec2 pixel_uv(ivec2 pixel) { return (vec2(pixel) + 0.5) / frame.size_time.xy; }

/// Metres to where a pixel's ray ends.
float pixel_metres(ivec2 pixel) {
    float depth = texelFetch(scene_depth, pixel, 0).r;
    return depth > 0.0 ? eye_distance(pixel_uv(pixel), depth) : farthest;
}
