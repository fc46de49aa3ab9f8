// All media of the frame, and what they do along a straight line. Same struct in media_buffer.cpp.
#include "physics/intersect.glsl"
#include "physics/phase.glsl"
#include "physics/transmittance.glsl"

struct GpuMedium {
    mat4 box_from_world;      // to the box [-1/2, 1/2]^3
    vec4 sigma_s_phase;       // rgb 1/m, w PHASE_...
    vec4 sigma_t;             // rgb 1/m
    vec4 phase_parameters;
};

layout(std430) readonly buffer Media { GpuMedium media[]; };
uniform int media_count;

// The part of the ray inside medium i; t in metres, since the direction is carried over unnormalised.
bool clip_to_medium(int i, vec3 origin, vec3 direction, inout float t0, inout float t1) {
    mat4 m = media[i].box_from_world;
    vec3 o = (m * vec4(origin, 1.0)).xyz;
    vec3 d = mat3(m) * direction;
    return clip_to_box(o, d, vec3(-0.5), vec3(0.5), t0, t1);
}

// Optical depth of all media between two distances on the ray.
vec3 media_optical_depth(vec3 origin, vec3 direction, float t_begin, float t_end) {
    vec3 depth = vec3(0.0);
    for (int i = 0; i < media_count; ++i) {
        float t0 = t_begin, t1 = t_end;
        if (clip_to_medium(i, origin, direction, t0, t1)) depth += media[i].sigma_t.rgb * (t1 - t0);
    }
    return depth;
}

// Share of the light that passes all media between two distances on the ray.
vec3 media_transmittance(vec3 origin, vec3 direction, float t_begin, float t_end) {
    return exp(-media_optical_depth(origin, direction, t_begin, t_end));
}
