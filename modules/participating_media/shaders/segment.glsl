// Provider of the media-segment seam: what the solvers gathered, and the transmittance of all media.
//
// Programs that only ask for the surface that is seen at uv define MEDIA_SEGMENT_OF_SURFACE. For places before it the
// froxels know their own part; all other terms are marched here.
#include "participating_media/media.glsl"
#include "physics/sequences.glsl"
#include "render/shaders/frame.glsl"
#include "render/shaders/seam_types.glsl"

uniform sampler2D media_in_scatter;  // rgb radiance between the eye and the surface, a that distance

#ifndef MEDIA_SEGMENT_OF_SURFACE
#include "participating_media/segment_march.glsl"
#endif

MediaSegment participating_media_segment(vec2 uv, vec3 p) {
    vec3 ray = p - frame.eye_near.xyz;
    float metres = length(ray);
    MediaSegment segment;
    media_sample_offset = interleaved_gradient_noise(uv * frame.size_time.xy);  // grain in place of rings
    segment.transmittance = media_transmittance(frame.eye_near.xyz, ray / metres, 0.0, metres);
    media_sample_offset = 0.5;
    vec4 whole = texelFetch(media_in_scatter, ivec2(uv * frame.size_time.xy), 0);
    segment.in_scatter = whole.rgb;
#ifndef MEDIA_SEGMENT_OF_SURFACE
    if (metres < whole.a * 0.999) segment.in_scatter = in_scatter_before(uv, ray / metres, metres);
#endif
    return segment;
}
