// Adds what the froxels found between the eye and each pixel's surface.
#include "participating_media/froxels/read.glsl"

uniform sampler2D scene_depth;

in vec2 uv;
out vec4 in_scatter;  // rgb radiance, a unused

void main() {
    float depth = texelFetch(scene_depth, ivec2(gl_FragCoord.xy), 0).r;
    in_scatter = vec4(froxel_in_scatter(uv, depth > 0.0 ? view_depth(depth) : 1e6), 0.0);
}
