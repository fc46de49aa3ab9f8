// Decides, once a frame, whether gathering goes on, begins again or has come to its end.
#include "translucency/radiance_maps/layers.glsl"

layout(local_size_x = 1) in;
uniform int restart;       // 1: something has changed that the light maps do not show
uniform int most_changed;  // texels that may change without a restart
uniform int frames;
uniform ivec2 gather_size;  // work groups
uniform ivec3 filter_size;
uniform ivec3 next_filter_size;

void main() {
    bool begins = restart > 0 || state.changed > uint(most_changed);
    state.changed = 0u;
    state.restarted = begins ? 1u : 0u;
    if (begins) state.gathered_frames = 0u;
    bool ends = state.gathered_frames >= uint(frames);
    if (!ends) state.gathered_frames += 1u;
    uint one = ends ? 0u : 1u;
    state.gather_groups = uvec4(uvec2(gather_size) * one, one, 0u);
    state.filter_groups = uvec4(uvec3(filter_size) * one, 0u);
    state.next_filter_groups = uvec4(uvec3(next_filter_size) * one, 0u);
}
