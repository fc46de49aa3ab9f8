// In-scatter from the eye to a place before the surface: what the froxels found, and a march of all other terms.
#include "participating_media/environment.glsl"
#include "participating_media/froxels/read.glsl"
#include "participating_media/scattering.glsl"
#include "render/shaders/lights.glsl"
#include "seams/light_transmittance.glsl"

const int SEGMENT_ENVIRONMENT = -1;
const int SEGMENT_EMISSION = -2;

uniform int segment_term_count;
uniform ivec3 segment_terms[64];  // light or SEGMENT_..., medium, 1 = what lies behind the froxels' grid alone
uniform int segment_steps;
uniform int froxels_active;  // 1 when there are froxels in this frame

// Radiance per metre that a term sends from p toward the eye.
vec3 segment_source(int source, int medium, vec3 p, vec3 direction, float spacing) {
    if (source == SEGMENT_EMISSION) return medium_density(medium, p, spacing) * medium_emission(medium, p);
    vec3 scattered = media[medium].sigma_s_phase.rgb * medium_density(medium, p, spacing);
    if (source == SEGMENT_ENVIRONMENT)
        return scattered * environment_share(p) * environment_transmittance(p) * environment_scattered(medium, p, direction);
    vec3 to_light;
    vec3 irradiance = light_irradiance(uint(source), p, to_light);
    return scattered * irradiance * medium_phase(medium, dot(to_light, direction)) * light_transmittance(uint(source), p, vec3(0.0));
}

// As shaders/march/march.frag: steps at equal angles seen from a light that has a place, else at equal distances.
vec3 segment_term(ivec3 term, vec3 origin, vec3 direction, float t0, float t1, float offset) {
    if (!clip_to_medium(term.y, origin, direction, t0, t1)) return vec3(0.0);
    if (term.x >= 0 && !light_segment(uint(term.x), origin, direction, t0, t1)) return vec3(0.0);
    bool angles = term.x >= 0 && light_kind(uint(max(term.x, 0))) != LIGHT_DIRECTIONAL;
    vec3 to_light = angles ? light_position(uint(term.x)) - origin : vec3(0.0);
    float closest = dot(to_light, direction);
    float passing = max(length(to_light - closest * direction), 1e-3);
    float from = angles ? atan((t0 - closest) / passing) : t0;
    float step_size = ((angles ? atan((t1 - closest) / passing) : t1) - from) / float(segment_steps);
    vec3 to_eye = media_transmittance(origin, direction, 0.0, t0);
    vec3 sum = vec3(0.0);
    float reached = t0;
    int i = 0;
    do {
        float at = from + (float(i) + offset) * step_size;
        float tangent = angles ? tan(at) : 0.0;
        float t = angles ? clamp(closest + passing * tangent, t0, t1) : at;
        float metres = angles ? passing * (1.0 + tangent * tangent) * step_size : step_size;
        to_eye *= exp(-media_optical_depth(origin, direction, reached, t, 1));
        reached = t;
        sum += to_eye * segment_source(term.x, term.y, origin + t * direction, direction, metres) * metres;
    } while (++i < segment_steps);
    return sum;
}

vec3 in_scatter_before(vec2 uv, vec3 direction, float metres) {
    float per_metre = -(frame.view * vec4(direction, 0.0)).z;
    vec3 sum = vec3(0.0);
    if (froxels_active != 0) sum = froxel_in_scatter(uv, min(metres * per_metre, froxel_depths.w));
    float offset = interleaved_gradient_noise(uv * frame.size_time.xy);
    for (int i = 0; i < segment_term_count; ++i) {
        float begin = segment_terms[i].z == 1 ? froxel_depths.w / per_metre : 0.0;
        if (begin < metres) sum += segment_term(segment_terms[i], frame.eye_near.xyz, direction, begin, metres, offset);
    }
    return sum;
}
