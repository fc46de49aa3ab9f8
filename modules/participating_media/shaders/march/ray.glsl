// Which ray a marched pixel stands for, and how far it goes.
#include "physics/intersect.glsl"
#include "render/shaders/frame.glsl"

uniform sampler2D scene_depth;
uniform int pixel_step;  // full-resolution pixels from one marched pixel to the next
uniform float farthest;  // metres; rays that hit nothing end here
#ifndef MEDIA_END
#define MEDIA_END 0  // 1: all media are in a box, and rays leave it
#endif
#if MEDIA_END == 1
uniform vec3 media_low, media_high;
#endif

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

/// The depth by which pixels are told apart: that of the surface or, where media end before it, of their end. What lies behind a
/// cloud makes no silhouette in it.
float reached_depth(ivec2 pixel) {
    float depth = texelFetch(scene_depth, pixel, 0).r;
#if MEDIA_END == 1
    float t0 = 0.0, t1 = 1e30;  // along the eye's axis
    if (clip_to_box(frame.eye_near.xyz, eye_ray_to_plane(pixel_uv(pixel)), media_low, media_high, t0, t1))
        depth = max(depth, frame.eye_near.w / t1);
#endif
    return depth;
}
