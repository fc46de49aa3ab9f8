// Where the froxels are (froxels/froxel_grid.h): columns over the picture, slices over the depth along the eye's axis.
#include "render/shaders/frame.glsl"

uniform ivec3 froxel_size;
uniform vec4 froxel_depths;  // begin, spread, growth, end; metres along the eye's axis
uniform float froxel_step;   // exp(growth / slices) - 1

// Depth at a share (0..1) of the grid, and back.
float froxel_depth(float share) { return froxel_depths.x + froxel_depths.y * (exp(froxel_depths.z * share) - 1.0); }
float froxel_share(float depth) { return log(1.0 + max(depth - froxel_depths.x, 0.0) / froxel_depths.y) / froxel_depths.z; }

// The middle of the slice that begins at a depth, in share of the grid.
float froxel_middle(float depth) { return depth + (sqrt(1.0 + froxel_step) - 1.0) * (depth - froxel_depths.x + froxel_depths.y); }

// Where the slice ends that begins at a depth.
float froxel_end(float depth) { return depth + froxel_step * (depth - froxel_depths.x + froxel_depths.y); }

uniform int slices_a_thread;  // FroxelVolume::slices_a_thread

// Where a froxel lies in its texture. A column lies together: renderers on processors spend their time waiting for memory.
ivec3 froxel_place(ivec3 froxel) { return froxel.zxy; }
vec3 froxel_place(vec3 share) { return share.zxy; }

// Pixels below a column: from here to the next one's.
ivec2 froxel_pixel(ivec2 column) { return column * ivec2(frame.size_time.xy) / froxel_size.xy; }
