// Takes the grain off what was marched: sums over neighbours of like distance, RADIUS pixels on each side. The errors of the
// blue-noise mask cancel over few pixels. Light and guide are summed alike, so that their quotient loses nothing that the
// guide knows.
#include "participating_media/march/ray.glsl"

uniform sampler2D marched;  // rgb radiance, a its guide

#ifdef AT_FULL_RESOLUTION
out vec4 filtered;  // rgb radiance, a metres
#else
out vec4 filtered;  // rgb radiance, a its guide
#endif

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    ivec2 last = textureSize(marched, 0) - 1;
    float depth = reached_depth(marched_pixel(pixel));
    float sharpness = 12.0 / max(depth, 1e-12);
    vec4 sum = vec4(0.0);
    for (int y = -RADIUS; y <= RADIUS; ++y) {
        for (int x = -RADIUS; x <= RADIUS; ++x) {
            ivec2 at = clamp(pixel + ivec2(x, y), ivec2(0), last);
            float other = reached_depth(marched_pixel(at));
            float weight = float((RADIUS + 1 - abs(x)) * (RADIUS + 1 - abs(y))) * max(0.0, 1.0 - sharpness * abs(other - depth));
            sum += weight * texelFetch(marched, at, 0);
        }
    }
#ifdef AT_FULL_RESOLUTION
    float guide = texelFetch(marched, pixel, 0).a;
    filtered = vec4(sum.a > 0.0 ? sum.rgb * (guide / sum.a) : vec3(0.0), pixel_metres(pixel));
#else
    filtered = sum;
#endif
}
