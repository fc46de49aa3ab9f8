// Blends across edges of the encoded picture, along them as far as they are straight (after FXAA 3, Lottes 2011).
#include "render/shaders/dither.glsl"

in vec2 uv;
layout(location = 0) out vec4 display;

uniform sampler2D encoded;  // luma in alpha

const float kEdgeThreshold = 0.125;   // contrast, relative to the brightest neighbour
const float kEdgeMinimum = 0.03;      // and absolute
const int kSteps = 4;                 // how far the ends of an edge are looked for ...
const float kStepSizes[kSteps] = float[](1.0, 1.5, 2.0, 4.0);  // ... in pixels

float luma_at(vec2 at) { return textureLod(encoded, at, 0.0).a; }

// Where the pixel's colour is read: moved across the edge it lies on.
vec2 smoothed_position(vec2 texel, float luma, float n, float s, float e, float w) {
    float nw = luma_at(uv + texel * vec2(-1, 1));
    float ne = luma_at(uv + texel * vec2(1, 1));
    float sw = luma_at(uv + texel * vec2(-1, -1));
    float se = luma_at(uv + texel * vec2(1, -1));
    float horizontal = abs(nw - 2.0 * w + sw) + 2.0 * abs(n - 2.0 * luma + s) + abs(ne - 2.0 * e + se);
    float vertical = abs(nw - 2.0 * n + ne) + 2.0 * abs(w - 2.0 * luma + e) + abs(sw - 2.0 * s + se);
    bool along_x = horizontal >= vertical;
    float positive = along_x ? n : e;
    float negative = along_x ? s : w;
    float side = abs(positive - luma) >= abs(negative - luma) ? 1.0 : -1.0;
    float contrast = 0.25 * max(abs(positive - luma), abs(negative - luma));
    float edge_luma = 0.5 * (luma + (side > 0.0 ? positive : negative));
    vec2 across = along_x ? vec2(0, texel.y) : vec2(texel.x, 0);
    vec2 along = along_x ? vec2(texel.x, 0) : vec2(0, texel.y);

    vec2 start = uv + 0.5 * side * across;
    float reach_a = 0.0;
    float reach_b = 0.0;
    float end_a = 0.0;
    float end_b = 0.0;
    bool open_a = true;
    bool open_b = true;
    for (int i = 0; i < kSteps; ++i) {
        if (open_a) {
            reach_a += kStepSizes[i];
            end_a = luma_at(start - along * reach_a) - edge_luma;
            open_a = abs(end_a) < contrast;
        }
        if (open_b) {
            reach_b += kStepSizes[i];
            end_b = luma_at(start + along * reach_b) - edge_luma;
            open_b = abs(end_b) < contrast;
        }
    }
    float nearest_end = reach_a < reach_b ? end_a : end_b;
    // only the side of the edge that turns away from this pixel's luma at the nearer end is blended
    bool turns = (nearest_end < 0.0) != (luma - edge_luma < 0.0);
    float by_edge = turns ? 0.5 - min(reach_a, reach_b) / (reach_a + reach_b) : 0.0;

    // single pixels that stand out are blended too
    float average = (2.0 * (n + s + e + w) + nw + ne + sw + se) / 12.0;
    float range = max(max(max(n, s), max(e, w)), luma) - min(min(min(n, s), min(e, w)), luma);
    float by_pixel = smoothstep(0.0, 1.0, clamp(abs(average - luma) / range, 0.0, 1.0));
    return uv + across * side * max(by_edge, 0.75 * by_pixel * by_pixel);
}

void main() {
    vec2 texel = 1.0 / frame.size_time.xy;
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    ivec2 last = ivec2(frame.size_time.xy) - 1;
    vec4 here = texelFetch(encoded, pixel, 0);
    float n = texelFetch(encoded, min(pixel + ivec2(0, 1), last), 0).a;
    float s = texelFetch(encoded, max(pixel - ivec2(0, 1), ivec2(0)), 0).a;
    float e = texelFetch(encoded, min(pixel + ivec2(1, 0), last), 0).a;
    float w = texelFetch(encoded, max(pixel - ivec2(1, 0), ivec2(0)), 0).a;
    float brightest = max(max(max(n, s), max(e, w)), here.a);
    float darkest = min(min(min(n, s), min(e, w)), here.a);
    vec3 colour = here.rgb;
    if (brightest - darkest >= max(kEdgeMinimum, kEdgeThreshold * brightest))
        colour = textureLod(encoded, smoothed_position(texel, here.a, n, s, e, w), 0.0).rgb;
    display = vec4(dithered(colour), 1.0);
}
