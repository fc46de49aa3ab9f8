// Optical depth of uneven media between a place and a light, from what shadows/media_shadows.h made ready.
#include "participating_media/media.glsl"
#include "participating_media/shadows/mapping.glsl"
#include "participating_media/shadows/clipmap.glsl"

// Same struct in shadows/media_shadows.cpp.
struct MediaShadow {
    mat4 map_from_world;  // to u, v (times w) and, of parallel rays, the share of the depths
    vec4 origin_kind;     // xyz the light, w MAP_...
    vec4 depths;          // x near in metres, y 1 / metres from near to far, z layers from the nearest to the farthest, w first layer + 1/2
    ivec4 turns;          // how often: x opacity map, y terms of the Fourier map, z the clipmap, w samples of the direct march
};
const int kMappedLights = 64;
layout(std140) uniform MediaShadows { MediaShadow media_shadows[kMappedLights]; };
uniform sampler3D media_shadow_maps;  // all lights' layers, stacked
uniform int media_shadows_others;     // samples of the direct march for lights beyond those

// u, v of the map and the share of its depths, 0 before the media and 1 behind them.
vec3 shadow_map_place(uint light, vec3 p) {
    vec4 at = media_shadows[light].map_from_world * vec4(p, 1.0);
    vec3 away = p - media_shadows[light].origin_kind.xyz;
    float metres = length(away);
    int kind = int(media_shadows[light].origin_kind.w);
    float depth = kind == MAP_PARALLEL ? at.z : (metres - media_shadows[light].depths.x) * media_shadows[light].depths.y;
    vec2 uv = at.w > 0.0 ? at.xy / at.w : vec2(-1.0);  // behind the light: the border, where there is nothing
    if (kind > 1) {
        float size = float(textureSize(media_shadow_maps, 0).x);
        uv = (octahedron_unfold(away / max(metres, 1e-6)) * (size - 2.0) / size + 1.0) * 0.5;
    }
    return vec3(uv, clamp(depth, 0.0, 1.0));
}

vec3 shadow_map_texel(vec2 uv, float layer) {
    return textureLod(media_shadow_maps, vec3(uv, layer / float(textureSize(media_shadow_maps, 0).z)), 0.0).rgb;
}

// Integral of the Fourier series up to the place's depth.
vec3 fourier_depth(uint light, vec3 at, int terms) {
    float layer = media_shadows[light].depths.w;
    vec3 whole = shadow_map_texel(at.xy, layer);
    vec3 depth = whole * at.z;
    float angle = 3.14159265 * at.z;
    float twice_cosine = 2.0 * cos(angle), before = 0.0, sine = sin(angle);
    for (int k = 1; k <= terms; ++k) {
        depth += shadow_map_texel(at.xy, layer + float(k)) * sine;
        float next = twice_cosine * sine - before;  // sin((k + 1) a)
        before = sine;
        sine = next;
    }
    return clamp(depth, vec3(0.0), whole);  // the series rings
}

vec3 light_uneven_depth(uint light, vec3 p, vec3 to_light, float metres) {
    vec3 depth = vec3(0.0);
    bool known = light < uint(kMappedLights);
    ivec4 turns = known ? media_shadows[light].turns : ivec4(0, 0, 0, media_shadows_others);
#ifdef MEDIA_SHADOWS_OPACITY
    if (turns.x > 0) {
        vec3 at = shadow_map_place(light, p);
        depth = shadow_map_texel(at.xy, media_shadows[light].depths.w + at.z * media_shadows[light].depths.z);
    }
#endif
#ifdef MEDIA_SHADOWS_FOURIER
    if (turns.y > 0) depth = fourier_depth(light, shadow_map_place(light, p), turns.y);
#endif
#ifdef MEDIA_SHADOWS_CLIPMAP
    if (turns.z > 0) depth = clipmap_depth(p, to_light, metres);
#endif
#ifdef MEDIA_SHADOWS_MARCHED
    if (turns.w > 0) depth = media_uneven_depth(p, to_light, 0.0, metres, turns.w);
#endif
    return depth;
}
