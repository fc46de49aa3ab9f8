// Light that has entered the other side of a thin part and leaves here, from the depths of the light's shadow map.
//
// A pixel gathers over the plane of its normal: each ring of the plane stands for what enters the other side as far
// beside, and one or two looks at the shadow map say how thick the skin is there. A slab's share T(s) is a sum over such
// rings, T(|s, low|) - T(|s, high|), if how much arrives goes by the distance alone: flat slabs are exact whatever light's
// angle, and where thickness changes light comes from beside.
#include "render/shaders/lights.glsl"
#include "skin/transmission/shares.glsl"
#include "seams/light_transmittance.glsl"

uniform sampler2DArray skin_shadow_depths;

/// Rings: outer radius, and where they are looked at, in widths of the table.
const int SKIN_RINGS = 4;
const vec2 SKIN_RING[SKIN_RINGS] = vec2[](vec2(0.35, 0.17), vec2(0.8, 0.55), vec2(1.4, 1.05), vec2(1e3, 1.8));
const float SKIN_NOTHING = 1e6;
/// Depths of four texels that are as many texels apart belong to two surfaces.
const float SKIN_STEEPEST = 6.0;
/// Radians between rings: the golden angle.
const float SKIN_TURN = 2.3999632;

/// A look at the scene from the light, around a point.
struct SkinView {
    vec4 at, x, y, light;  // of the point in the page, and of a metre along both of the plane's directions and to the light
    vec4 rectangle;
    float page;
    float texel;  // metres, times w
    vec2 depth;   // perspective: depth = x + y / metres along the axis; directional: x is the depth of a metre
    float metres;  // from the light
};

SkinView skin_view(ShadowView view, vec3 p, vec3 x, vec3 y, vec3 to_light, float metres) {
    mat4 m = view.page_from_world;
    SkinView result = SkinView(m * vec4(p, 1.0), m * vec4(x, 0.0), m * vec4(y, 0.0), m * vec4(to_light, 0.0),
                               view.rectangle, view.texel_page_fades.y,
                               view.texel_page_fades.x, vec2(0.0), metres);
    vec3 axis = transpose(m)[3].xyz;
    if (dot(axis, axis) > 0.0) {
        vec4 depth = transpose(m)[2];
        result.depth.x = dot(depth.xyz, axis) / dot(axis, axis);
        result.depth.y = depth.w - result.depth.x * transpose(m)[3].w;
    } else {
        result.depth.x = result.light.z;
    }
    return result;
}

/// Metres along the light's ray from the plane at `place` up to the first surface that the light meets; below the plane
/// negative. SKIN_NOTHING where there is nothing.
float skin_depth(SkinView view, vec2 place) {
    vec4 at = view.at + place.x * view.x + place.y * view.y;
    at.w = max(at.w, 1e-6);
    vec2 uv = clamp(at.xy / at.w, view.rectangle.xy, view.rectangle.zw);
    vec4 texels = textureGather(skin_shadow_depths, vec3(uv, view.page));
    vec4 z = (texels - at.z) / view.depth.x;
    if (view.depth.y != 0.0) z = (1.0 - view.depth.y / ((texels - view.depth.x) * at.w)) * view.metres;
    vec2 f = fract(uv * vec2(textureSize(skin_shadow_depths, 0).xy) - 0.5);
    vec2 rows = mix(z.wx, z.zy, f.x);
    float between = mix(rows.x, rows.y, f.y);
    // between two surfaces there is none: the nearest texel's
    vec2 low = min(z.xy, z.zw), high = max(z.xy, z.zw);
    bool torn = max(high.x, high.y) - min(low.x, low.y) > SKIN_STEEPEST * view.texel * at.w;
    vec2 row = f.y < 0.5 ? z.wz : z.xy;
    vec2 row_texels = f.y < 0.5 ? texels.wz : texels.xy;
    float nearest = f.x < 0.5 ? row.x : row.y;
    float stored = f.x < 0.5 ? row_texels.x : row_texels.y;
    return stored > 0.0 ? (torn ? nearest : between) : SKIN_NOTHING;
}

/// The cascade, cone or face that sees p; none: page -1.
ShadowView skin_shadow_view(uint light, vec3 p, vec3 to_light) {
    if (light_kind(light) != LIGHT_DIRECTIONAL) return shadow_view(light, -to_light);
    ShadowView found = light_data(light).views[0];
    float page = -1.0;
    for (int i = shadow_view_count(light) - 1; i >= 0; --i) {
        ShadowView view = light_data(light).views[i];
        vec2 at = (view.page_from_world * vec4(p, 1.0)).xy;
        vec2 inside = min(at - view.rectangle.xy, view.rectangle.zw - at);
        if (min(inside.x, inside.y) > 0.0) {
            found = view;
            page = view.texel_page_fades.y;
        }
    }
    found.texel_page_fades.y = page;
    return found;
}

/// What of the light goes into the light buffer at p, a point of the skin `number` with the mesh's normal n.
vec3 skin_transmitted(uint light, vec3 p, vec3 n, float number, float roughness) {
    vec3 to_light;
    float metres = light_distance(light, p, to_light);
    SkinSurface skin = skin_surface(number);
    float cosine = -dot(n, to_light);
    float shown = skin.transmission * smoothstep(0.0, SKIN_GRAZING, cosine);
    SkinThrough through = skin_through_surface(number);
    ShadowView shadow = skin_shadow_view(light, p, to_light);
    if (!(skin.profile > 0.0) || shadow.texel_page_fades.y < 0.0) shown = 0.0;

    vec3 side = abs(n.y) < 0.9 ? vec3(0.0, 1.0, 0.0) : vec3(1.0, 0.0, 0.0);
    vec3 x = normalize(cross(side, n));
    vec3 y = cross(n, x);
    SkinView view = skin_view(shadow, p, x, y, to_light, metres);
    // light slants through: its middle lies beside
    vec2 slant = vec2(dot(to_light, x), dot(to_light, y));
    float first = max(skin_depth(view, vec2(0.0)), 0.0);
    vec2 middle = -min(first, 2.0 * through.width / max(cosine, SKIN_GRAZING)) * slant;

    mat3x4 box = mat3x4(through.x, through.y, through.z);
    vec3 box_at = vec4(p, 1.0) * box, box_x = vec4(x, 0.0) * box, box_y = vec4(y, 0.0) * box;
    vec3 box_light = vec4(to_light, 0.0) * box;
    vec3 beyond = 1.0 + (shadow.texel_page_fades.x * view.at.w + 0.0002) *
                            vec3(length(through.x.xyz), length(through.y.xyz), length(through.z.xyz));

    vec3 sum = vec3(0.0);
    float low = 0.0;
    mat2 spread = mat2(0.0);  // normal equations of the other side's slope
    vec2 rise = vec2(0.0);
    vec2 toward = vec2(1.0, 0.0);
    const mat2 kTurn = mat2(cos(SKIN_TURN), sin(SKIN_TURN), -sin(SKIN_TURN), cos(SKIN_TURN));
    int rings = shown > 0.0 ? SKIN_RINGS : 0;  // loops end early even where branches are not skipped
    for (int i = 0; i < rings; ++i) {
        vec2 ring = SKIN_RING[i] * through.width;
        vec2 direction = ring.y * toward;
        vec2 z, kept;
        vec3 shares[2];
        for (int j = 0; j < 2; ++j) {
            vec2 place = middle + (j == 0 ? direction : -direction);
            float up = skin_depth(view, place);
            vec3 in_box = abs(box_at + place.x * box_x + place.y * box_y + up * box_light);
            float h = up * cosine;
            vec2 beside = place + up * slant;
            // what is not as deep as in the middle lies elsewhere beside
            float squared = h * h + max(dot(beside, beside) - ring.y * ring.y, -low * low);
            vec3 share = skin_share(through, squared + low * low) - skin_share(through, squared + ring.x * ring.x);
            kept[j] = all(lessThan(in_box, beyond)) ? 1.0 : 0.0;
            shares[j] = kept[j] * share;
            z[j] = up;
        }
        sum += 0.5 * (shares[0] + shares[1]);
        float weight = min(shares[0].r, shares[1].r);
        spread += weight * outerProduct(direction, direction);
        rise += weight * 0.5 * (z.x - z.y) * direction;
        low = ring.x;
        toward = kTurn * toward;
    }
    // the other side's normal: what faces as the pixel does is on its own side, where light spreads by diffusion
    float regular = 1e-3 * (spread[0][0] + spread[1][1]) + 1e-12;
    mat2 solved = spread + mat2(regular);
    vec2 slope = rise.x == 0.0 && rise.y == 0.0 ? vec2(0.0) : inverse(solved) * rise;
    vec3 entry = normalize(cross(y + slope.y * to_light, x + slope.x * to_light));
    float other_side = clamp(0.5 - 0.5 * dot(entry, n), 0.0, 1.0);
    float enters = skin_enters(skin, max(dot(entry, to_light), 0.0), roughness);

    vec3 from;
    vec3 irradiance = light_irradiance(light, p, from);
    // what else is in light's way before it enters
    float above = (first < SKIN_NOTHING ? first : 0.0) + 3.0 * shadow.texel_page_fades.x * view.at.w;
    vec3 arriving = light_transmittance(light, p + above * to_light, vec3(0.0));
    return irradiance * arriving * sum * (shown * max(cosine, 0.0) * other_side * enters);
}
