// The scene's lights: GpuLight of render/frame.h, same order as RenderScene's.
//
// A program that looks at one light a draw defines ONE_LIGHT: it gets the light bound by bind_light() whatever number it
// asks for. It may define as well what it knows of that light (LightPrograms writes all of it): LIGHT_KIND as one of
// the LIGHT_ constants, LIGHT_GOBO and LIGHT_HIGHLIGHT 0 or 1, SHADOW_VIEWS. What is known is not branched on, which counts where both sides
// of a branch are paid for (llvmpipe).
#include "physics/intersect.glsl"
#include "physics/light_profile.glsl"
#include "physics/units.glsl"
#include "render/shaders/frame.glsl"

const int LIGHT_POINT = 0;
const int LIGHT_SPOT = 1;
const int LIGHT_DIRECTIONAL = 2;

/// One look at the scene from a light, for its shadow map.
struct ShadowView {
    mat4 page_from_world;   // to u, v of a page, depth; w is 1 or metres along the view's axis
    vec4 rectangle;         // low and high uv of the view, less half a texel
    vec4 texel_page_fades;  // metres a texel covers (times w), page, 1 = the scene goes on beyond the border
};

struct GpuLight {
    vec4 position_range;     // metres; range 0 = none
    vec4 direction_kind;     // travel direction, LIGHT_...
    vec4 right_cos_outer;    // local +X
    vec4 up_cos_inner;       // local +Y
    vec4 intensity_profile;  // cd or lux, SPOT_...
    vec4 gobo;    // layer or -1, half size in metres (directional) or tan(outer) (spot), size of the emitter in metres
    vec4 shadow;  // number of views; 1 = makes no highlights
    ShadowView views[6];
    vec4 padding[5];
};

#ifdef ONE_LIGHT
layout(std140) uniform Light { GpuLight one_light; };
#define light_data(light) one_light
#else
layout(std430) readonly buffer Lights { GpuLight lights[]; };
#define light_data(light) lights[light]
#endif

uniform sampler2DArray light_gobos;  // linear transmittance; v = 0 is an image's top

/// How far away a directional light counts as being, metres.
const float LIGHT_FAR = 1e6;

int light_kind(uint light) {
#ifdef LIGHT_KIND
    return LIGHT_KIND;
#else
    return int(light_data(light).direction_kind.w);
#endif
}

bool light_has_gobo(uint light) {
#ifdef LIGHT_GOBO
    return LIGHT_GOBO != 0;
#else
    return light_data(light).gobo.x >= 0.0;
#endif
}

/// Whether surfaces mirror it: lights that stand for the environment are seen in the mirror image of that.
bool light_has_highlight(uint light) {
#ifdef LIGHT_HIGHLIGHT
    return LIGHT_HIGHLIGHT != 0;
#else
    return light_data(light).shadow.y == 0.0;
#endif
}

/// Where a point or spot light stands, or the middle of a directional one's gobo.
vec3 light_position(uint light) { return light_data(light).position_range.xyz; }

/// Metres from p to the light, and the unit direction there.
float light_distance(uint light, vec3 p, out vec3 to_light) {
    if (light_kind(light) == LIGHT_DIRECTIONAL) {
        to_light = -light_data(light).direction_kind.xyz;
        return LIGHT_FAR;
    }
    vec3 offset = light_data(light).position_range.xyz - p;
    float metres = length(offset);
    to_light = offset / max(metres, 1e-6);
    return metres;
}

/// What the slide in front of the light lets through toward p. Seen from the light along its axis the image stands
/// upright: left is -X, its top is +Y. A spot's image spans the square about its outer cone; a directional light's
/// spans the rectangle of gobo_size_m about the light's origin, and its edge texels go on outside of it.
vec3 light_gobo(uint light, vec3 p) {
    if (!light_has_gobo(light)) return vec3(1.0);
    vec4 gobo = light_data(light).gobo;
    vec3 offset = p - light_data(light).position_range.xyz;
    vec2 half_size = gobo.yz;  // metres at p
    if (light_kind(light) == LIGHT_SPOT) half_size *= max(dot(offset, light_data(light).direction_kind.xyz), 1e-6);
    vec2 at = vec2(dot(offset, light_data(light).right_cos_outer.xyz), -dot(offset, light_data(light).up_cos_inner.xyz));
    vec2 texels = vec2(textureSize(light_gobos, 0).xy) / (2.0 * half_size);  // a metre
    float lod = log2(max(max(texels.x, texels.y) * pixel_footprint(p), 1.0));
    return textureLod(light_gobos, vec3(0.5 + 0.5 * at / half_size, gobo.x), lod).rgb;
}

/// Illuminance (lux per channel) that a plane at p facing the light receives when nothing is in between, and the unit
/// direction to the light.
vec3 light_irradiance(uint light, vec3 p, out vec3 to_light) {
    float metres = light_distance(light, p, to_light);
    vec4 intensity = light_data(light).intensity_profile;
    int kind = light_kind(light);
    if (kind == LIGHT_DIRECTIONAL) return intensity.rgb * light_gobo(light, p);
    float share = point_irradiance(1.0, metres) * range_window(metres, light_data(light).position_range.w);
    if (kind == LIGHT_POINT) return intensity.rgb * share;
    share *= spot_falloff(int(intensity.w), -dot(to_light, light_data(light).direction_kind.xyz),
                          light_data(light).up_cos_inner.w, light_data(light).right_cos_outer.w);
    if (share <= 0.0) return vec3(0.0);
    return intensity.rgb * share * light_gobo(light, p);
}

/// Narrows [t0, t1] of a ray (unit direction) to what is within `margin` metres of what the light can reach; false when
/// nothing is left.
bool light_segment(uint light, vec3 origin, vec3 direction, float margin, inout float t0, inout float t1) {
    int kind = light_kind(light);
    if (kind == LIGHT_DIRECTIONAL) return t0 < t1;
    vec4 sphere = light_data(light).position_range;
    if (sphere.w > 0.0 && !clip_to_sphere(origin, direction, sphere.xyz, sphere.w + margin, t0, t1)) return false;
    float cos_outer = light_data(light).right_cos_outer.w;
    if (kind == LIGHT_POINT || cos_outer < 0.0872) return t0 < t1;  // such a wide cone is not clipped to
    vec3 axis = light_data(light).direction_kind.xyz;
    vec3 apex = sphere.xyz - margin * inversesqrt(max(1.0 - cos_outer * cos_outer, 1e-6)) * axis;
    return clip_to_infinite_cone(origin, direction, apex, axis, cos_outer, t0, t1);
}

/// The same for what it can reach.
bool light_segment(uint light, vec3 origin, vec3 direction, inout float t0, inout float t1) {
    return light_segment(light, origin, direction, 0.0, t0, t1);
}
