// Provider "shadow_maps" of the light-transmittance seam (render/shadow_maps.h).
//
// Surfaces: p is moved along its normal by the filter's reach times the sine between normal and view axis. A plane
// through p is then behind p for every texel of the filter, whatever its slope: no acne, and no more of a gap at
// contacts than needed. 5x5 texels are filtered by 9 bilinear comparisons (Castano, The Witness, 2013). Points in a
// volume (n = 0): one comparison.
#include "render/shaders/lights.glsl"

struct ShadowView {
    mat4 page_from_world;   // to u, v of the page, depth
    vec4 rectangle;         // low and high uv of the view, less half a texel
    vec4 texel_page_fades;  // metres a texel covers (times w), layer, 1 = the scene goes on beyond the border
};

layout(std430) readonly buffer ShadowViews { ShadowView shadow_views[]; };

uniform sampler2DArrayShadow shadow_map_depths;

/// How far a surface point is moved along its normal and toward the light, in texels.
const float SHADOW_NORMAL_OFFSET = 3.2;
const float SHADOW_DEPTH_OFFSET = 0.3;
/// The part of a cascade's width over which it goes over into the next.
const float SHADOW_BLEND = 0.08;

/// Share of light at a place of a page, one comparison of 2x2 texels.
float shadow_tap(int view, vec2 uv, float depth) {
    vec4 rectangle = shadow_views[view].rectangle;
    return texture(shadow_map_depths,
                   vec4(clamp(uv, rectangle.xy, rectangle.zw), shadow_views[view].texel_page_fades.y, max(depth, 0.0)));
}

/// The same, filtered over 5x5 texels.
float shadow_filtered(int view, vec3 at) {
    vec2 size = vec2(textureSize(shadow_map_depths, 0).xy);
    vec2 base = floor(at.xy * size + 0.5);
    vec2 f = at.xy * size + 0.5 - base;
    base -= 0.5;
    vec3 wx = vec3(4.0 - 3.0 * f.x, 7.0, 1.0 + 3.0 * f.x);
    vec3 wy = vec3(4.0 - 3.0 * f.y, 7.0, 1.0 + 3.0 * f.y);
    vec3 x = (vec3(3.0 - 2.0 * f.x, 3.0 + f.x, f.x) / wx + vec3(-2.0, 0.0, 2.0) + base.x) / size.x;
    vec3 y = (vec3(3.0 - 2.0 * f.y, 3.0 + f.y, f.y) / wy + vec3(-2.0, 0.0, 2.0) + base.y) / size.y;
    float sum = 0.0;
    for (int j = 0; j < 3; ++j)
        for (int i = 0; i < 3; ++i) sum += wx[i] * wy[j] * shadow_tap(view, vec2(x[i], y[j]), at.z);
    return sum / 144.0;
}

/// Share of light at p through one view along `axis`; `at` is p in the view's page.
float shadow_in_view(int view, vec4 at, vec3 axis, vec3 p, vec3 n, vec3 to_light) {
    if (n == vec3(0.0)) return shadow_tap(view, at.xy / at.w, at.z / at.w);
    float texel = shadow_views[view].texel_page_fades.x * at.w;  // w is 1 or metres from the light
    float cosine = dot(n, axis);
    float sine = sqrt(max(1.0 - cosine * cosine, 0.0));
    vec3 moved = p + texel * (SHADOW_NORMAL_OFFSET * sine * n + SHADOW_DEPTH_OFFSET * to_light);
    at = shadow_views[view].page_from_world * vec4(moved, 1.0);
    return shadow_filtered(view, at.xyz / at.w);
}

/// The finest cascade that holds p, blended into the next near its border; lit beyond the last.
float shadow_cascades(int first, int count, vec3 p, vec3 n, vec3 to_light) {
    float lit = 0.0;
    float rest = 1.0;
    for (int view = first; view < first + count; ++view) {
        vec4 at = shadow_views[view].page_from_world * vec4(p, 1.0);
        vec4 rectangle = shadow_views[view].rectangle;
        vec2 inside = min(at.xy - rectangle.xy, rectangle.zw - at.xy) / (rectangle.zw - rectangle.xy);
        float border = min(inside.x, inside.y);
        if (border <= 0.0) continue;
        float share = rest * (shadow_views[view].texel_page_fades.z > 0.0 ? min(border / SHADOW_BLEND, 1.0) : 1.0);
        lit += share * shadow_in_view(view, at, to_light, p, n, to_light);
        rest -= share;
        if (rest <= 0.0) break;
    }
    return lit + rest;
}

/// Faces in the order +X -X +Y -Y +Z -Z.
int cube_face(vec3 d) {
    vec3 a = abs(d);
    if (a.x >= a.y && a.x >= a.z) return d.x > 0.0 ? 0 : 1;
    if (a.y >= a.z) return d.y > 0.0 ? 2 : 3;
    return d.z > 0.0 ? 4 : 5;
}

vec3 shadow_maps_transmittance(uint light, vec3 p, vec3 n) {
    int first = int(lights[light].shadow.x);
    int count = int(lights[light].shadow.y);
    if (first < 0) return vec3(1.0);
    vec3 to_light;
    light_distance(light, p, to_light);
    if (light_kind(light) == LIGHT_DIRECTIONAL) return vec3(shadow_cascades(first, count, p, n, to_light));
    int view = count > 1 ? first + cube_face(-to_light) : first;
    vec4 at = shadow_views[view].page_from_world * vec4(p, 1.0);
    if (at.w <= 0.0) return vec3(1.0);  // behind a spot: it gives no light there
    vec3 axis = transpose(shadow_views[view].page_from_world)[3].xyz;  // whose w is the distance along it
    return vec3(shadow_in_view(view, at, axis, p, n, to_light));
}
