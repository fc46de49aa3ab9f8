// What was marched at a lower resolution, brought to the frame's: bilinear weights, times how well the marched distance
// fits. No halo at edges.
#include "render/shaders/frame.glsl"

uniform sampler2D scene_depth;
uniform sampler2D marched;  // rgb radiance, a metres marched
uniform float farthest;     // metres; rays that hit nothing end here

in vec2 uv;
out vec4 in_scatter;  // rgb radiance, a metres

void main() {
    float depth = texelFetch(scene_depth, ivec2(gl_FragCoord.xy), 0).r;
    float metres = depth > 0.0 ? eye_distance(uv, depth) : farthest;
    ivec2 size = textureSize(marched, 0);
    vec2 position = uv * vec2(size) - 0.5;
    ivec2 corner = ivec2(floor(position));
    vec2 f = position - vec2(corner);
    vec3 sum = vec3(0.0);
    float total = 0.0;
    for (int i = 0; i < 4; ++i) {
        ivec2 offset = ivec2(i & 1, i >> 1);
        vec4 texel = texelFetch(marched, clamp(corner + offset, ivec2(0), size - 1), 0);
        vec2 w = mix(1.0 - f, f, vec2(offset));
        float weight = (w.x * w.y + 1e-4) / (1e-3 + abs(texel.a - metres) / max(metres, 1e-3));
        sum += texel.rgb * weight;
        total += weight;
    }
    in_scatter = vec4(sum / total, metres);
}
