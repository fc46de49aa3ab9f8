// The map's light blurred by a model of diffusion, by distances in space, at every other pixel: what leaves there of light
// that has entered beyond the first ring around it.
#include "translucency/scatter_maps/map.glsl"
#include "translucency/scatter_maps/places.glsl"
#include "translucency/scatter_maps/solid.glsl"

layout(location = 0) out vec4 near;  // exitance, lm/m2: of light from near by, and from deep inside
layout(location = 1) out vec4 deep;

/// The mean of 1 / r^3 over a range of depths about `deeper`, at a squared distance across, over its value at the middle.
/// Kernels fall about so.
float spread_over(float across2, float deeper, float range) {
    float inverse = 1.0 / across2, half_range = max(0.5 * range, 1e-3 * sqrt(across2));
    float near = deeper - half_range, far = deeper + half_range;
    float sum = far * inversesqrt(1.0 + far * far * inverse) - near * inversesqrt(1.0 + near * near * inverse);
    float middle = 1.0 + deeper * deeper * inverse;
    return sum / (2.0 * half_range) * middle * sqrt(middle);
}

/// Width of a tap's part of a ring over the ring's.
const float kTapShare = 0.8;

void main() {
    vec2 found = texelFetch(blur_places, ivec2(gl_FragCoord.xy), 0).xy;
    vec3 start = light_place(place_of(ivec2(gl_FragCoord.xy), max(found, vec2(1e-6, 0.0))));
    int rings = found.x > 0.0 ? kRings : 0, ring = 0;
    vec3 from_near = vec3(0.0), from_deep = vec3(0.0);
    float width = window_metres(start.z);
    vec2 uv = map_uv(start), uv_per_metre = vec2(1.0 / (view.window.z * width));
    do {
        vec4 fluxes[kRingTaps];  // a: depth
        float low = 1e30, high = -1e30;
        for (int i = 0; i < kRingTaps; ++i) {
            vec4 tap = solid.taps[ring * kRingTaps + i];
            vec4 flux = textureLod(entry_flux, uv + tap.xy * uv_per_metre, ceil(map_lod(tap.z)));
            float light = luminance_rec709(flux.rgb);
            flux.a = flux.a / max(light, 1e-20) + view.window.w;
            low = min(low, light > 0.0 ? flux.a : low);
            high = max(high, light > 0.0 ? flux.a : high);
            fluxes[i] = flux;
        }
        for (int i = 0; i < kRingTaps; ++i) {
            vec4 tap = solid.taps[ring * kRingTaps + i], flux = fluxes[i];
            vec2 apart = across(uv + tap.xy * uv_per_metre, flux.a) - start.xy;
            float wider = window_metres(flux.a) / width, r2 = dot(apart, apart), deeper = flux.a - start.z;
            // of a ring the depths are known at six places: what a tap stands for has its part of their range
            float range = max(high - low, 0.0) * kTapShare;
            vec4 kernel = kernel_here(r2 + deeper * deeper);
            vec3 leaves = kernel.rgb * flux.rgb * (tap.w * wider * wider * spread_over(r2, deeper, range));
            from_near += leaves * (1.0 - kernel.a);
            from_deep += leaves * kernel.a;
        }
    } while (++ring < rings);
    // where nothing is seen the place lies so far away that what was reckoned may be no number, which no weight takes away
    near = found.x > 0.0 ? vec4(from_near, 0.0) : vec4(0.0);
    deep = found.x > 0.0 ? vec4(from_deep, 0.0) : vec4(0.0);
}
