// What the media-segment seam says of a place at a fixed depth on each pixel's ray.
#include "render/shaders/frame.glsl"
#include "seams/media_segment.glsl"

uniform float metres;  // along the eye's axis

in vec2 uv;
out vec4 found;

void main() {
    MediaSegment segment = media_segment(uv, frame.eye_near.xyz + metres * eye_ray_to_plane(uv));
    found = vec4(segment.in_scatter, 1.0);
}
