// Adds what the froxels found between the eye and each pixel's surface. In compute, where cards that are made for
// computing have all of themselves at hand.
#define FROXEL_IMAGES
#include "participating_media/froxels/read.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

uniform sampler2D scene_depth;
layout(rgba32f) uniform image2D media_in_scatter;  // rgb radiance, a that distance

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, ivec2(frame.size_time.xy)))) return;
    vec2 uv = (vec2(pixel) + 0.5) / frame.size_time.xy;
    float depth = texelFetch(scene_depth, pixel, 0).r;
    vec4 in_scatter = imageLoad(media_in_scatter, pixel);
    in_scatter.rgb += froxel_in_scatter(uv, depth > 0.0 ? view_depth(depth) : 1e6);
    imageStore(media_in_scatter, pixel, in_scatter);
}
