// Half of a separable blur: along u (ALONG_U) from `map` to `other`, or back across it. Weights of the taps make the
// wanted variance whatever it is (texture_space/lobe_plan.h); taps on other charts don't count.
#include "skin/texture_space/atlas.glsl"

layout(rgba32f) uniform image2D map;
layout(rgba32f) uniform image2D other;
layout(rgba32f) readonly uniform image2D steps;
uniform sampler2D kernels;  // a row for each number of taps
uniform float variance;     // of the surface, m2
uniform float less;         // off the variance along each axis of the map, texels squared
uniform int most_taps;      // on each side
#ifndef ALONG_U
layout(rgba32f) uniform image2D total;
uniform vec3 weight;  // of the result in `total`
uniform vec3 sharp;   // and of what was there before
uniform float keeps;  // 0: `total` begins here
#endif
const float kColumns = 64.0, kRows = 6.0, kCutOff = 2.2;

/// As many as the variance wants.
int taps_for(float texels2) { return clamp(int(ceil(2.8 * sqrt(texels2))), 1, most_taps); }
/// q of the weights q^(i^2).
float kernel_base(float texels2, int taps) {
    float deviation = float(taps) / kCutOff;
    float column = clamp(texels2 / (deviation * deviation), 0.0, 1.0) * (kColumns - 1.0);
    return textureLod(kernels, vec2((column + 0.5) / kColumns, (float(taps) - 0.5) / kRows), 0.0).x;
}

/// What is to be spread: along u; along v; and columns that the latter leans by a row. The covariance is the surface's
/// less what has been spread evenly over the map's axes.
vec3 variances(vec3 step) {
    float along_v = variance * step.z * step.z, along_u = variance * step.x * step.x;
#ifdef LEANS
    float both = step.y * along_v, left_v = max(along_v - less, 0.25 * along_v);
    float left_u = along_u + step.y * both - less - both * both / left_v;
    float lean = both / left_v;
    // taps between columns spread along u as well
    left_u -= min(1.0 / 6.0, 0.8 * abs(lean) * sqrt(left_v));
    return vec3(max(left_u, 0.0), left_v, lean);
#else
    return vec3(max(vec2(along_u, along_v) - less, 0.0), 0.0);
#endif
}

void tap(vec4 texel, float chart, float amount, inout vec4 sum) {
    sum += (texel.a == chart ? amount : 0.0) * vec4(texel.rgb, 1.0);
}

void main() {
    uint entry = list_entry();
    if (entry >= list_size) return;
    vec4 step = imageLoad(steps, list_texel(entry));
    vec3 left = variances(step.xyz);
    ivec2 at = map_texel(step.w);
#ifdef ALONG_U
    float texels2 = left.x;
    vec4 own = imageLoad(map, at);
#else
    float texels2 = left.y;
    vec4 own = imageLoad(other, at);
#endif
    int taps = taps_for(texels2);
    float q = kernel_base(texels2, taps), amount = q, ratio = q * q * q;
    vec4 sum = vec4(own.rgb, 1.0);
    for (int i = 1; i <= taps; ++i) {
#ifdef ALONG_U
        tap(imageLoad(map, at + ivec2(i, 0)), own.a, amount, sum);
        tap(imageLoad(map, at - ivec2(i, 0)), own.a, amount, sum);
#elif defined(LEANS)
        float x = left.z * float(i), low = floor(x);
        ivec2 there = ivec2(low, i);
        float right = x - low;
        tap(imageLoad(other, at + there), own.a, amount * (1.0 - right), sum);
        tap(imageLoad(other, at + there + ivec2(1, 0)), own.a, amount * right, sum);
        tap(imageLoad(other, at - there), own.a, amount * (1.0 - right), sum);
        tap(imageLoad(other, at - there - ivec2(1, 0)), own.a, amount * right, sum);
#else
        tap(imageLoad(other, at + ivec2(0, i)), own.a, amount, sum);
        tap(imageLoad(other, at - ivec2(0, i)), own.a, amount, sum);
#endif
        amount *= ratio;
        ratio *= q * q;
    }
    vec3 result = sum.rgb / sum.a;
#ifdef ALONG_U
    imageStore(other, at, vec4(result, own.a));
#else
    vec3 all = weight * result;
    if (sharp != vec3(0.0)) all += sharp * imageLoad(map, at).rgb;
    if (keeps != 0.0) all += imageLoad(total, at).rgb;
    imageStore(total, at, vec4(all, own.a));
    imageStore(map, at, vec4(result, own.a));
#endif
}
