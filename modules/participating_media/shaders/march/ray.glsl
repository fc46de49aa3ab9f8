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

/// The depth at which a pixel's ray leaves all media, 0 if it does not. Pixels are told apart by depths no farther than that: what
/// lies behind a cloud makes no silhouette in it.
float media_end_depth(ivec2 pixel) {
#if MEDIA_END == 1
    vec2 uv = pixel_uv(pixel);
    float t0 = 0.0, t1 = farthest;
    if (clip_to_box(frame.eye_near.xyz, eye_ray(uv), media_low, media_high, t0, t1))
        return eye_distance(uv, 1.0) / t1;  // depths are one over metres
#endif
    return 0.0;
}
