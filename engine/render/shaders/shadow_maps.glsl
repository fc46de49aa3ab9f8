// Provider "shadow_maps" of the light-transmittance seam (render/shadow_maps.h).
//
// Surfaces: p is moved along its normal by the filter's reach times the sine between normal and view axis. A plane
// through p is then behind p for every texel of the filter, whatever its slope: no acne, and no more of a gap at
// contacts than needed. 5x5 texels are filtered by 9 bilinear comparisons (Castano, The Witness, 2013). Points in a
// volume (n = 0): one comparison.
#include "render/shaders/lights.glsl"

uniform sampler2DArrayShadow shadow_map_depths;

/// How far a surface point is moved along its normal and toward the light, in texels.
const float SHADOW_NORMAL_OFFSET = 3.2;
const float SHADOW_DEPTH_OFFSET = 0.3;
/// The part of a cascade's width over which it goes over into the next.
const float SHADOW_BLEND = 0.08;

/// Where to look in the pages.
struct ShadowPlace {
    vec3 at;  // u, v, depth
    vec4 rectangle;
    float page;
};

/// Share of light there, one comparison of 2x2 texels.
float shadow_tap(ShadowPlace place) {
    return texture(shadow_map_depths, vec4(clamp(place.at.xy, place.rectangle.xy, place.rectangle.zw), place.page,
                                           max(place.at.z, 0.0)));
}

/// The same, filtered over 5x5 texels.
float shadow_filtered(ShadowPlace place) {
    vec2 size = vec2(textureSize(shadow_map_depths, 0).xy);
    vec4 rectangle = place.rectangle * size.xyxy + vec4(2.0, 2.0, -2.0, -2.0);
    vec2 texel = clamp(place.at.xy * size, rectangle.xy, rectangle.zw) + 0.5;
    vec2 base = floor(texel);
    vec2 f = texel - base;
    vec3 wx = vec3(4.0 - 3.0 * f.x, 7.0, 1.0 + 3.0 * f.x);
    vec3 wy = vec3(4.0 - 3.0 * f.y, 7.0, 1.0 + 3.0 * f.y);
    vec3 x = (vec3(3.0 - 2.0 * f.x, 3.0 + f.x, f.x) / wx + vec3(-2.5, -0.5, 1.5) + base.x) / size.x;
    vec3 y = (vec3(3.0 - 2.0 * f.y, 3.0 + f.y, f.y) / wy + vec3(-2.5, -0.5, 1.5) + base.y) / size.y;
    vec2 page_depth = vec2(place.page, max(place.at.z, 0.0));
    float sum = 0.0;
    for (int j = 0; j < 3; ++j)
        for (int i = 0; i < 3; ++i) sum += wx[i] * wy[j] * texture(shadow_map_depths, vec4(x[i], y[j], page_depth));
    return sum / 144.0;
}

/// Where a view along `axis` sees p; `at` is p in its page.
ShadowPlace shadow_place(ShadowView view, vec4 at, vec3 axis, vec3 p, vec3 n, vec3 to_light) {
    if (n != vec3(0.0)) {
        float texel = view.texel_page_fades.x * at.w;
        float cosine = dot(n, axis);
        float sine = sqrt(max(1.0 - cosine * cosine, 0.0));
        vec3 moved = p + texel * (SHADOW_NORMAL_OFFSET * sine * n + SHADOW_DEPTH_OFFSET * to_light);
        at = view.page_from_world * vec4(moved, 1.0);
    }
    return ShadowPlace(at.xyz / at.w, view.rectangle, view.texel_page_fades.y);
}

float shadow_share(ShadowPlace place, bool filtered) { return filtered ? shadow_filtered(place) : shadow_tap(place); }

int shadow_view_count(uint light) {
#ifdef SHADOW_VIEWS
    return SHADOW_VIEWS;
#else
    return int(light_data(light).shadow.x);
#endif
}

/// The finest cascade that holds p, blended near its border into the next that does; lit beyond the last.
float shadow_cascades(uint light, vec3 p, vec3 n) {
    vec3 to_light = -light_data(light).direction_kind.xyz;
    ShadowPlace fine, coarse;
    float share = 1.0;  // of `fine`
    int found = 0;
    int count = shadow_view_count(light);
    for (int i = 0; i < count; ++i) {
        ShadowView view = light_data(light).views[i];
        vec4 at = view.page_from_world * vec4(p, 1.0);
        vec2 inside = min(at.xy - view.rectangle.xy, view.rectangle.zw - at.xy) / (view.rectangle.zw - view.rectangle.xy);
        float border = min(inside.x, inside.y);
        if (border > 0.0 && found < 2) {
            coarse = shadow_place(view, at, to_light, p, n, to_light);
            if (found == 0) {
                fine = coarse;
                share = view.texel_page_fades.z > 0.0 ? min(border / SHADOW_BLEND, 1.0) : 1.0;
            }
            found = share < 1.0 ? found + 1 : 2;
        }
    }
    if (found == 0) return 1.0;
    bool filtered = n != vec3(0.0);
    if (share >= 1.0) found = 1;
    // A loop, since many pixels agree that one look is enough, and loops end early even where branches are not skipped.
    float lit = share < 1.0 && found < 2 ? 1.0 - share : 0.0;
    do {
        lit += share * shadow_share(fine, filtered);
        fine = coarse;
        share = 1.0 - share;
    } while (--found > 0);
    return lit;
}

/// Faces in the order +X -X +Y -Y +Z -Z.
int cube_face(vec3 d) {
    vec3 a = abs(d);
    if (a.x >= a.y && a.x >= a.z) return d.x > 0.0 ? 0 : 1;
    if (a.y >= a.z) return d.y > 0.0 ? 2 : 3;
    return d.z > 0.0 ? 4 : 5;
}

/// The view that holds the direction from a point or spot light.
ShadowView shadow_view(uint light, vec3 direction) {
    int count = shadow_view_count(light);
    if (count == 1) return light_data(light).views[0];
    int face = cube_face(direction);
#if defined(ONE_LIGHT) && defined(SHADOW_VIEWS)
    ShadowView view = light_data(light).views[0];  // loads from known places are cheaper than one from a computed place
    for (int i = 1; i < count; ++i)
        if (i == face) view = light_data(light).views[i];
    return view;
#else
    return light_data(light).views[face];
#endif
}

vec3 shadow_maps_transmittance(uint light, vec3 p, vec3 n) {
    if (shadow_view_count(light) == 0) return vec3(1.0);
    if (light_kind(light) == LIGHT_DIRECTIONAL) return vec3(shadow_cascades(light, p, n));
    vec3 to_light;
    light_distance(light, p, to_light);
    ShadowView view = shadow_view(light, -to_light);
    vec4 at = view.page_from_world * vec4(p, 1.0);
    vec3 axis = transpose(view.page_from_world)[3].xyz;  // whose w is the distance along it
    float lit = shadow_share(shadow_place(view, at, axis, p, n, to_light), n != vec3(0.0));
    return vec3(at.w > 0.0 ? lit : 1.0);  // behind a spot it gives no light anyway
}
