// The end of march.glsl, emission.glsl and environment.glsl: adds march_pixel() to where it belongs.
//
// A fragment shader at each marched pixel. GUIDE_ONLY: at each pixel of the frame, its guide times the share of it that was
// marched near by; with SPREAD a compute shader that finds the share itself, for a term that is alone. LISTED: a compute
// shader at the pixels that the shares say nothing of.
#ifdef LISTED
layout(local_size_x = 64) in;
layout(std430) readonly buffer UnknownPixels { uint unknown_groups[3]; uint unknown_count; uint unknown_pixels[]; };
layout(rgba32f) uniform image2D media_in_scatter;

void main() {
    if (gl_GlobalInvocationID.x >= unknown_count) return;
    uint place = unknown_pixels[gl_GlobalInvocationID.x];
    ivec2 pixel = ivec2(place & 0xffffu, place >> 16);
    vec4 before = imageLoad(media_in_scatter, pixel);
    imageStore(media_in_scatter, pixel, vec4(before.rgb + march_pixel(pixel, pixel).rgb, before.a));
}
#elif defined(SPREAD)
#include "participating_media/march/shares.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(rgba32f) writeonly uniform image2D media_in_scatter;

void write_pixel(ivec2 pixel, vec3 share) {
    imageStore(media_in_scatter, pixel, vec4(share * march_pixel(pixel, pixel).a, pixel_metres(pixel)));
}

void main() { spread_shares(); }
#else
#ifdef GUIDE_ONLY
uniform sampler2D media_shares;  // rgb light over its guide
#endif

out vec4 in_scatter;  // rgb radiance, a its guide

void main() {
    ivec2 at = ivec2(gl_FragCoord.xy);
    in_scatter = march_pixel(marched_pixel(at), at);
#ifdef GUIDE_ONLY
    in_scatter.rgb = in_scatter.a * texelFetch(media_shares, at, 0).rgb;
#endif
}
#endif
