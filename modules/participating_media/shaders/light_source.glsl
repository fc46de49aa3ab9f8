// One light in one medium, as the solvers of single scattering see it along an eye ray.
//
// IGNORE_SHADOW_MAPS leaves the shadow maps out of what dims the light: for solvers that find shadows in another way.
#ifdef IGNORE_SHADOW_MAPS
#undef SHADOW_VIEWS
#define SHADOW_VIEWS 0
#endif
#include "participating_media/media.glsl"
#include "render/shaders/frame.glsl"
#include "render/shaders/lights.glsl"
#include "seams/light_transmittance.glsl"

uniform uint light_index;
#ifdef ONE_MEDIUM
const int medium = 0;
#else
uniform int medium;
#endif

struct Ray {
    vec3 origin;
    vec3 direction;
};

#if PHASE_KIND == 8  // tabulated
uniform sampler2D phase_tables;  // a row for each medium, over the scattering angle
vec3 phase(float u) {
    float width = float(textureSize(phase_tables, 0).x);
    float column = 0.5 + acos(clamp(u, -1.0, 1.0)) * 0.31830989 * (width - 1.0);
    return textureLod(phase_tables, vec2(column / width, (float(medium) + 0.5) / 16.0), 0.0).rgb;
}
#else
float phase(float u) { return phase_evaluate(PHASE_KIND, media[medium].phase_parameters, u); }
#endif

// Radiance per metre that the light sends from the ray's point t to the eye, before the way there.
vec3 source(Ray ray, float t) {
    vec3 p = ray.origin + t * ray.direction;
    vec3 to_light;
    vec3 irradiance = light_irradiance(light_index, p, to_light);
    return irradiance * phase(dot(-to_light, -ray.direction)) * light_transmittance(light_index, p, vec3(0.0)) *
           medium_density(medium, p);
}
