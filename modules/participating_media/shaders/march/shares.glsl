// What was marched at a lower resolution, brought to the frame's: light over its guide, from the nearest four marched pixels.
// Those of another distance do not count, unless all lie in one plane. Pixels of which they say too little, at silhouettes
// and where they disagree, are listed: their rays are marched at full resolution.
#include "participating_media/march/guide.glsl"

layout(rgba32f) readonly uniform image2D marched;  // rgb radiance, a its guide
layout(std430) buffer UnknownPixels { uint unknown_groups[3]; uint unknown_count; uint unknown_pixels[]; };

const float kLike = 0.06;       // relative difference of depths within which light before them is alike
const float kLeast = 0.70;      // weight of those that fit, below which nothing is known
const float kDisagree = 0.5;    // (most - least) / (most + least) of shares, above which nothing is known
const float kFlat = 0.02;       // how far, relative, depths may stray from a plane

void list(ivec2 pixel) {
    uint index = atomicAdd(unknown_count, 1u);
    if ((index & 63u) == 0u) atomicAdd(unknown_groups[0], 1u);
    unknown_pixels[index] = uint(pixel.x) | uint(pixel.y) << 16;
}

/// The share of a pixel whose depth this is; 0 where it is listed.
vec3 share_of(ivec2 pixel, float depth) {
    ivec2 last = imageSize(marched) - 1;
    vec2 position = (vec2(pixel) - float(pixel_step / 2)) / float(pixel_step);
    ivec2 corner = ivec2(floor(position));
    vec2 f = position - vec2(corner);
    float sharpness = 1.0 / max(kLike * depth, 1e-12);
    vec4 sum = vec4(0.0), plane = vec4(0.0);
    float fits = 0.0, mean = 0.0, off_plane = 0.0, least = 1e30, most = 0.0;
    for (int i = 0; i < 4; ++i) {
        ivec2 offset = ivec2(i & 1, i >> 1);
        ivec2 at = clamp(corner + offset, ivec2(0), last);
        vec4 texel = imageLoad(marched, at);
        float other = texelFetch(scene_depth, marched_pixel(at), 0).r;
        vec2 w = mix(1.0 - f, f, vec2(offset));
        float weight = w.x * w.y + 1e-4;
        float like = weight * max(0.0, 1.0 - sharpness * abs(other - depth));
        sum += like * texel;
        fits += like;
        plane += weight * texel;
        mean += weight * other;
        off_plane += (i == 0 || i == 3 ? 1.0 : -1.0) * other;
        float share = luminance_rec709(texel.rgb) / max(texel.a, 1e-30);
        least = min(least, share);
        most = max(most, share);
    }
    // depths of a plane are linear on the screen
    bool flat_there = max(abs(off_plane), abs(mean - depth)) <= kFlat * depth;
    sum = flat_there ? plane : sum;
    bool known = (flat_there || fits > kLeast) && most - least <= kDisagree * (most + least) && sum.a > 0.0;
    if (!known && plane.a > 0.0) list(pixel);
    return known ? sum.rgb / max(sum.a, 1e-30) : vec3(0.0);
}
