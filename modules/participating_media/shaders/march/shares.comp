// The shares of a frame (shares.glsl), for terms that are drawn after it: several lights have one share.
#include "participating_media/march/shares.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

layout(rgba32f) writeonly uniform image2D media_in_scatter;  // rgb radiance, a metres
layout(rgba16f) writeonly uniform image2D media_shares;      // rgb light over its guide

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, ivec2(frame.size_time.xy)))) return;
    float depth = texelFetch(scene_depth, pixel, 0).r;
    imageStore(media_shares, pixel, vec4(share_of(pixel, depth), 0.0));
    imageStore(media_in_scatter, pixel, vec4(0.0, 0.0, 0.0, depth > 0.0 ? eye_distance(pixel_uv(pixel), depth) : farthest));
}
