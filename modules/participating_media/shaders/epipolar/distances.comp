// Metres from the eye to the surface at each sample of each slice; negative on slices without length.
#include "render/shaders/frame.glsl"

layout(local_size_x = 64) in;

uniform sampler2D scene_depth;
uniform float farthest;  // metres; rays that hit nothing end here
uniform int slices;
uniform int samples;
layout(rgba32f) uniform readonly image2D slice_ends;
layout(r32f) uniform writeonly image2D distances;

void main() {
    ivec2 at = ivec2(gl_GlobalInvocationID.xy);  // slice, sample
    if (at.x >= slices) return;
    vec4 ends = imageLoad(slice_ends, ivec2(at.x, 0));
    vec2 pixel = mix(ends.xy, ends.zw, float(at.y) / float(samples - 1));
    ivec2 texel = clamp(ivec2(pixel), ivec2(0), ivec2(frame.size_time.xy) - 1);
    float depth = texelFetch(scene_depth, texel, 0).r;
    float metres = depth > 0.0 ? eye_distance(pixel / frame.size_time.xy, depth) : farthest;
    imageStore(distances, at, vec4(ends.xy == ends.zw ? -1.0 : metres));
}
