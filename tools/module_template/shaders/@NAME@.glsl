// Provider of the media-segment seam (render/seams.h).
#include "physics/transmittance.glsl"
#include "render/shaders/frame.glsl"
#include "render/shaders/seam_types.glsl"

uniform vec3 @NAME@_radiance;
uniform float @NAME@_density;

MediaSegment @NAME@_segment(vec2 uv, vec3 p) {
    MediaSegment segment;
    segment.transmittance = beer_lambert(vec3(@NAME@_density), distance(p, frame.eye_near.xyz));
    segment.in_scatter = @NAME@_radiance * (1.0 - segment.transmittance);
    return segment;
}
