#include "render/shaders/seam_types.glsl"

uniform sampler2D paint;

MediaSegment painter_segment(vec2 uv, vec3 p) {
    return MediaSegment(texture(paint, uv).rgb, vec3(0.25));
}
