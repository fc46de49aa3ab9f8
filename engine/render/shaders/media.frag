// radiance * transmittance + in-scattered light, by dual-source blending.
#include "render/shaders/frame.glsl"
#include "seams/media_segment.glsl"

in vec2 uv;
layout(location = 0, index = 0) out vec4 in_scatter;
layout(location = 0, index = 1) out vec4 transmittance;

uniform sampler2D scene_depth;

// How far a segment reaches where there is no surface, metres.
const float kSkyDistance = 1e5;

void main() {
    float depth = texelFetch(scene_depth, ivec2(gl_FragCoord.xy), 0).x;
    vec3 p = depth > 0.0 ? world_from_depth(uv, depth) : frame.eye_near.xyz + kSkyDistance * eye_ray(uv);
    MediaSegment segment = media_segment(uv, p);
    in_scatter = vec4(segment.in_scatter, 0.0);
    transmittance = vec4(segment.transmittance, 1.0);
}
