// Provider of the media-segment seam: what the solvers gathered, and the transmittance of all media.
#include "participating_media/froxels/read.glsl"
#include "participating_media/media.glsl"
#include "render/shaders/frame.glsl"
#include "render/shaders/seam_types.glsl"

uniform int media_once;              // 1: a loop that may be left out
uniform int froxels_active;          // 1 when there are froxels in this frame
uniform sampler2D media_in_scatter;  // rgb radiance between the eye and the surface, a that distance

MediaSegment participating_media_segment(vec2 uv, vec3 p) {
    vec3 ray = p - frame.eye_near.xyz;
    float metres = length(ray);
    MediaSegment segment;
    segment.transmittance = media_transmittance(frame.eye_near.xyz, ray / metres, 0.0, metres);
    vec4 whole = texelFetch(media_in_scatter, ivec2(uv * frame.size_time.xy), 0);
    segment.in_scatter = whole.rgb;
    for (int k = 0; k < (metres < whole.a * 0.999 ? media_once : 0); ++k) {
        // before the surface: the froxels know their own part; of the rest that share which the transmittance tells
        vec3 direction = ray / metres;
        float per_metre = -(frame.view * vec4(direction, 0.0)).z;
        vec3 froxels = vec3(0.0), froxels_whole = vec3(0.0);
        for (int i = 0; i < froxels_active; ++i) {
            froxels = froxel_in_scatter(uv, metres * per_metre);
            froxels_whole = froxel_in_scatter(uv, whole.a * per_metre);
        }
        vec3 lost = 1.0 - media_transmittance(frame.eye_near.xyz, direction, 0.0, whole.a);
        vec3 share = mix(vec3(metres / whole.a), (1.0 - segment.transmittance) / max(lost, vec3(1e-6)), greaterThan(lost, vec3(1e-4)));
        segment.in_scatter = froxels + max(whole.rgb - froxels_whole, vec3(0.0)) * min(share, vec3(1.0));
    }
    return segment;
}
