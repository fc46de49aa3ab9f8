// What is seen through a column of froxels: x depth of the farthest surface along the eye's
// axis, yz where it is in the picture, w depth of the nearest.
#include "participating_media/froxels/grid.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

uniform sampler2D scene_depth;
uniform ivec2 pixels;  // of the largest column
layout(rgba32f) writeonly uniform image2D froxel_columns;

void main() {
    ivec2 column = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(column, froxel_size.xy))) return;
    ivec2 low = froxel_pixel(column), last = max(froxel_pixel(column + 1) - 1, low);
    float farthest = 2.0, nearest = 0.0;  // reversed
    ivec2 place = low;
    for (int y = 0; y < pixels.y; ++y) {
        for (int x = 0; x < pixels.x; ++x) {
            ivec2 pixel = min(low + ivec2(x, y), last);
            float depth = texelFetch(scene_depth, pixel, 0).r;
            place = depth < farthest ? pixel : place;
            farthest = min(farthest, depth);
            nearest = max(nearest, depth);
        }
    }
    float metres = farthest > 0.0 ? view_depth(farthest) : 1e30;
    imageStore(froxel_columns, column, vec4(metres, (vec2(place) + 0.5) / frame.size_time.xy, nearest > 0.0 ? view_depth(nearest) : 1e30));
}
