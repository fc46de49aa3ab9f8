// How deep a column of froxels is looked into: x as deep as it or a neighbour sees, for those are interpolated; y as it sees itself.
#include "participating_media/froxels/grid.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

layout(rgba32f) readonly uniform image2D froxel_columns;
layout(rg32f) writeonly uniform image2D froxel_reach;

void main() {
    ivec2 column = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(column, froxel_size.xy))) return;
    float reach = 0.0;
    for (int y = -1; y <= 1; ++y)
        for (int x = -1; x <= 1; ++x)
            reach = max(reach, imageLoad(froxel_columns, clamp(column + ivec2(x, y), ivec2(0), froxel_size.xy - 1)).x);
    imageStore(froxel_reach, column, vec4(reach, imageLoad(froxel_columns, column).x, 0.0, 0.0));
}
