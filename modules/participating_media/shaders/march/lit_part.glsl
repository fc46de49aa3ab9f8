// Leaves out the ends of a ray's part that are wholly in shadow, by a pyramid of least depths (march/shadow_mips.h). For lights
// that look at the scene once.
uniform sampler2DArray shadow_mips;  // least and largest depth
uniform int shadow_mip_levels;

const int kPieces = 4;

/// Everything between two places of the shadow map lies behind what the light sees there.
bool all_dark(vec3 a, vec3 b, vec4 rectangle, float page) {
    float texels = 8.0 * float(textureSize(shadow_mips, 0).x);
    vec2 low = clamp(min(a.xy, b.xy), rectangle.xy, rectangle.zw) * texels - 1.0;  // a comparison looks at 2x2 texels
    vec2 high = clamp(max(a.xy, b.xy), rectangle.xy, rectangle.zw) * texels + 1.0;
    vec2 extent = high - low;
    int level = int(max(ceil(log2(max(extent.x, extent.y) / 8.0)), 0.0));
    level = min(level, shadow_mip_levels - 1);
    ivec2 cell = ivec2(max(low, vec2(0.0)) / (8.0 * exp2(float(level))));
    ivec2 last = textureSize(shadow_mips, level).xy - 1;
    float least = 1e30;
    for (int i = 0; i < 4; ++i)
        least = min(least, texelFetch(shadow_mips, ivec3(min(cell + ivec2(i & 1, i >> 1), last), int(page)), level).r);
    return max(a.z, b.z) < least;
}

/// Narrows [t0, t1]; false when nothing is lit.
bool clip_to_lit(vec3 origin, vec3 direction, inout float t0, inout float t1) {
    ShadowView view = light_data(light_index).views[0];
    vec4 start = view.page_from_world * vec4(origin, 1.0), along = view.page_from_world * vec4(direction, 0.0);
    float piece = (t1 - t0) / float(kPieces);
    vec4 at = start + t0 * along;
    vec3 before = at.xyz / max(at.w, 1e-6);
    float low = t1, high = t0;
    for (int i = 0; i < kPieces; ++i) {
        float begin = t0 + float(i) * piece;
        at = start + (begin + piece) * along;
        vec3 after = at.xyz / max(at.w, 1e-6);
        bool lit = !all_dark(before, after, view.rectangle, view.texel_page_fades.y);
        low = lit ? min(low, begin) : low;
        high = lit ? begin + piece : high;
        before = after;
    }
    t0 = low;
    t1 = min(high, t1);
    return t0 < t1;
}
