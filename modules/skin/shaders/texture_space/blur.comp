// Half of a separable blur: along u (ALONG_U) from `map` to `other`, or back across it. RADIUS taps on each side, whose
// weights make the wanted variance whatever it is (texture_space/lobe_plan.h); taps on other charts don't count.
#include "skin/texture_space/atlas.glsl"

layout(rgba32f) uniform image2D map;
layout(rgba32f) uniform image2D other;
layout(rgba32f) readonly uniform image2D steps;
layout(r32f) readonly uniform image2D charts;
uniform sampler2D kernels;  // a row for each radius
uniform float variance;     // of the surface, m2
uniform float less;         // texels squared
#ifndef ALONG_U
layout(rgba32f) uniform image2D total;
uniform vec3 weight;  // of the result in `total`
uniform vec3 sharp;   // and of what was there before
uniform float keeps;  // 0: `total` begins here
#endif
const float kColumns = 64.0, kRows = 6.0;
uniform float widest;  // variance of the last column

/// q of the weights q^(i^2).
float kernel_base(float texels2) {
    float column = clamp(texels2 / widest, 0.0, 1.0) * (kColumns - 1.0);
    return textureLod(kernels, vec2((column + 0.5) / kColumns, (float(RADIUS) - 0.5) / kRows), 0.0).x;
}

void tap(vec4 texel, float chart, float amount, inout vec4 sum) {
    sum += (texel.a == chart ? amount : 0.0) * vec4(texel.rgb, 1.0);
}

void main() {
    uint entry = gl_GlobalInvocationID.x;
    if (entry >= list_size) return;
    vec4 step = imageLoad(steps, list_texel(entry));
    float chart = imageLoad(charts, list_texel(entry)).x;
    ivec2 at = map_texel(step.w);
#ifdef ALONG_U
    float texels2 = variance * step.x * step.x - less;
#ifdef LEANS
    // taps between texels, in the other half, spread along u as well
    texels2 -= min(1.0 / 6.0, 0.8 * abs(step.y) * sqrt(variance) * step.z);
#endif
#else
    float texels2 = variance * step.z * step.z - less;
#endif
    float q = kernel_base(max(texels2, 0.0));
    float amount = q, ratio = q * q * q;
#ifdef ALONG_U
    vec4 sum = vec4(imageLoad(map, at).rgb, 1.0);
    for (int i = 1; i <= RADIUS; ++i) {
        tap(imageLoad(map, at + ivec2(i, 0)), chart, amount, sum);
        tap(imageLoad(map, at - ivec2(i, 0)), chart, amount, sum);
        amount *= ratio;
        ratio *= q * q;
    }
    imageStore(other, at, vec4(sum.rgb / sum.a, chart));
#else
    vec4 sum = vec4(imageLoad(other, at).rgb, 1.0);
    for (int i = 1; i <= RADIUS; ++i) {
#ifdef LEANS
        float x = step.y * float(i), low = floor(x);
        ivec2 there = ivec2(low, i);
        float right = x - low;
        tap(imageLoad(other, at + there), chart, amount * (1.0 - right), sum);
        tap(imageLoad(other, at + there + ivec2(1, 0)), chart, amount * right, sum);
        tap(imageLoad(other, at - there), chart, amount * (1.0 - right), sum);
        tap(imageLoad(other, at - there - ivec2(1, 0)), chart, amount * right, sum);
#else
        tap(imageLoad(other, at + ivec2(0, i)), chart, amount, sum);
        tap(imageLoad(other, at - ivec2(0, i)), chart, amount, sum);
#endif
        amount *= ratio;
        ratio *= q * q;
    }
    vec3 result = sum.rgb / sum.a;
    vec3 all = weight * result;
    if (sharp != vec3(0.0)) all += sharp * imageLoad(map, at).rgb;
    if (keeps != 0.0) all += imageLoad(total, at).rgb;
    imageStore(total, at, vec4(all, chart));
    imageStore(map, at, vec4(result, chart));
#endif
}
