// The shares of a frame (shares.glsl), for terms that are drawn after it: several lights have one share.
#include "participating_media/march/shares.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

layout(rgba32f) writeonly uniform image2D media_in_scatter;  // rgb radiance, a metres
layout(rgba16f) writeonly uniform image2D media_shares;      // rgb light over its guide

void write_pixel(ivec2 pixel, vec3 share) {
    imageStore(media_shares, pixel, vec4(share, 0.0));
    imageStore(media_in_scatter, pixel, vec4(0.0, 0.0, 0.0, pixel_metres(pixel)));
}

void main() { spread_shares(); }
