// All media of the frame, and what they do along a straight line. Same struct in media_buffer.cpp.
//
// A program that knows that there is one medium defines ONE_MEDIUM: what lies in a uniform block at a known place is
// much faster to read on llvmpipe.
#include "physics/intersect.glsl"
#include "physics/phase.glsl"
#include "physics/transmittance.glsl"

struct GpuMedium {
    mat4 box_from_world;    // to the box [-1/2, 1/2]^3
    vec4 sigma_s_phase;     // rgb 1/m, w PHASE_...
    vec4 sigma_t;           // rgb 1/m
    vec4 phase_parameters;
};

layout(std140) uniform Media { GpuMedium media[16]; };
#ifdef ONE_MEDIUM
const int media_count = 1;
#else
uniform int media_count;
#endif

// The part of the ray inside medium i; t in metres, since the direction is carried over unnormalised.
bool clip_to_medium(int i, vec3 origin, vec3 direction, inout float t0, inout float t1) {
    mat4 m = media[i].box_from_world;
    vec3 o = (m * vec4(origin, 1.0)).xyz;
    vec3 d = mat3(m) * direction;
    vec3 inverse = 1.0 / mix(d, vec3(1e-20), lessThan(abs(d), vec3(1e-20)));
    vec3 a = (-0.5 - o) * inverse;
    vec3 b = (0.5 - o) * inverse;
    vec3 near = min(a, b), far = max(a, b);
    t0 = max(t0, max(near.x, max(near.y, near.z)));
    t1 = min(t1, min(far.x, min(far.y, far.z)));
    return t0 < t1;
}

// Optical depth of all media between two distances on the ray.
vec3 media_optical_depth(vec3 origin, vec3 direction, float t_begin, float t_end) {
    vec3 depth = vec3(0.0);
    for (int i = 0; i < media_count; ++i) {
        float t0 = t_begin, t1 = t_end;
        bool inside = clip_to_medium(i, origin, direction, t0, t1);
        depth += media[i].sigma_t.rgb * (inside ? t1 - t0 : 0.0);
    }
    return depth;
}

// Share of the light that passes all media between two distances on the ray.
vec3 media_transmittance(vec3 origin, vec3 direction, float t_begin, float t_end) {
    return exp(-media_optical_depth(origin, direction, t_begin, t_end));
}
