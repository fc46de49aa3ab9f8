// Provider of the media-segment seam: what the solvers gathered, and the transmittance of all media.
#include "participating_media/media.glsl"
#include "render/shaders/frame.glsl"
#include "render/shaders/seam_types.glsl"

uniform sampler2D media_in_scatter;  // rgb radiance between the eye and the surface, a that distance

MediaSegment participating_media_segment(vec2 uv, vec3 p) {
    vec3 ray = p - frame.eye_near.xyz;
    float metres = length(ray);
    MediaSegment segment;
    segment.transmittance = media_transmittance(frame.eye_near.xyz, ray / metres, 0.0, metres);
    segment.in_scatter = texelFetch(media_in_scatter, ivec2(uv * frame.size_time.xy), 0).rgb;
    return segment;
}
