// Provider of the media-segment seam: what the march gathered, and the transmittance of all media.
#include "participating_media/media.glsl"
#include "render/shaders/frame.glsl"
#include "render/shaders/seam_types.glsl"

uniform sampler2D media_in_scatter;  // rgb radiance, a distance that was marched

// Depth-aware upsampling (the bilinear weights, times how well the marched distance fits): no halo at edges.
vec3 upsampled_in_scatter(vec2 uv, float metres) {
    ivec2 size = textureSize(media_in_scatter, 0);
    vec2 position = uv * vec2(size) - 0.5;
    ivec2 corner = ivec2(floor(position));
    vec2 f = position - vec2(corner);
    vec3 sum = vec3(0.0);
    float total = 0.0;
    for (int i = 0; i < 4; ++i) {
        ivec2 offset = ivec2(i & 1, i >> 1);
        vec4 texel = texelFetch(media_in_scatter, clamp(corner + offset, ivec2(0), size - 1), 0);
        vec2 w = mix(1.0 - f, f, vec2(offset));
        float weight = (w.x * w.y + 1e-4) / (1e-3 + abs(texel.a - metres) / max(metres, 1e-3));
        sum += texel.rgb * weight;
        total += weight;
    }
    return sum / total;
}

MediaSegment participating_media_segment(vec2 uv, vec3 p) {
    vec3 ray = p - frame.eye_near.xyz;
    float metres = length(ray);
    MediaSegment segment;
    segment.transmittance = media_transmittance(frame.eye_near.xyz, ray / metres, 0.0, metres);
    segment.in_scatter = textureSize(media_in_scatter, 0) == ivec2(frame.size_time.xy)
                             ? texelFetch(media_in_scatter, ivec2(uv * frame.size_time.xy), 0).rgb
                             : upsampled_in_scatter(uv, metres);
    return segment;
}
