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

/// Four marched pixels, and what is the same for all pixels of the frame between them.
struct Neighbours {
    ivec2 corner;  // the first of them
    vec4 texels[4];
    float depths[4];
    float off_plane, least, most;
};

Neighbours neighbours_from(ivec2 corner) {
    Neighbours n;
    n.corner = corner;
    n.off_plane = 0.0;
    n.least = 1e30;
    n.most = 0.0;
    ivec2 last = imageSize(marched) - 1;
    for (int i = 0; i < 4; ++i) {
        ivec2 at = clamp(corner + ivec2(i & 1, i >> 1), ivec2(0), last);
        n.texels[i] = imageLoad(marched, at);
        n.depths[i] = reached_depth(marched_pixel(at));
        n.off_plane += (i == 0 || i == 3 ? 1.0 : -1.0) * n.depths[i];
        float share = luminance_rec709(n.texels[i].rgb) / max(n.texels[i].a, 1e-30);
        n.least = min(n.least, share);
        n.most = max(n.most, share);
    }
    return n;
}

/// The share of a pixel between them; 0 where it is listed.
vec3 share_of(Neighbours n, ivec2 pixel) {
    float depth = reached_depth(pixel);
    vec2 f = (vec2(pixel) - float(pixel_step / 2)) / float(pixel_step) - vec2(n.corner);
    float sharpness = 1.0 / max(kLike * depth, 1e-12);
    vec4 sum = vec4(0.0), plane = vec4(0.0);
    float fits = 0.0, mean = 0.0;
    for (int i = 0; i < 4; ++i) {
        vec2 w = mix(1.0 - f, f, vec2(i & 1, i >> 1));
        float weight = w.x * w.y + 1e-4;
        float like = weight * max(0.0, 1.0 - sharpness * abs(n.depths[i] - depth));
        sum += like * n.texels[i];
        fits += like;
        plane += weight * n.texels[i];
        mean += weight * n.depths[i];
    }
    // depths of a plane are linear on the screen
    bool flat_there = max(abs(n.off_plane), abs(mean - depth)) <= kFlat * depth;
    sum = flat_there ? plane : sum;
    bool known = (flat_there || fits > kLeast) && n.most - n.least <= kDisagree * (n.most + n.least) && sum.a > 0.0;
    if (!known && plane.a > 0.0) list(pixel);
    return known ? sum.rgb / max(sum.a, 1e-30) : vec3(0.0);
}

void write_pixel(ivec2 pixel, vec3 share);

/// An invocation's four marched pixels, and all pixels of the frame between them: write_pixel() gets each with its share.
void spread_shares() {
    Neighbours n = neighbours_from(ivec2(gl_GlobalInvocationID.xy) - 1);
    ivec2 first = n.corner * pixel_step + pixel_step / 2, size = ivec2(frame.size_time.xy);
    int i = 0;
    do {
        ivec2 pixel = first + ivec2(i % pixel_step, i / pixel_step);
        if (all(greaterThanEqual(pixel, ivec2(0))) && all(lessThan(pixel, size))) write_pixel(pixel, share_of(n, pixel));
    } while (++i < pixel_step * pixel_step);
}
