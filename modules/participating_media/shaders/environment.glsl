// Light from all around, scattered by media (environment.h).
//
// The radiance is known by its first three bands, the phase function keeps a share of each. All of it is dimmed by the mean
// transmittance over a few directions, weighed by the light from there. No surface shadows it.
#include "participating_media/media.glsl"
#include "physics/sh.glsl"

uniform vec4 environment_harmonics[9];
uniform mat3 environment_image_from_world;
uniform vec3 environment_bands[16];       // a medium each
uniform int environment_count;            // of the directions: not a constant, or compilers unroll all media into each
uniform vec4 environment_directions[14];  // xyz in the world
uniform vec3 environment_weights[14];
uniform int environment_boxes;            // light probes with a box: in there it is not seen
uniform mat4 environment_box_from_world[8];
uniform vec4 environment_box_extent[8];   // half extents, w metres over which it fades

const float kEnvironmentFar = 1e5;  // metres

// What the boxes leave of it at a place.
float environment_share(vec3 p) {
    float left = 1.0;
    for (int i = 0; i < environment_boxes; ++i) {
        vec4 extent = environment_box_extent[i];
        vec3 inside = extent.xyz - abs((environment_box_from_world[i] * vec4(p, 1.0)).xyz);
        left *= 1.0 - clamp(min(inside.x, min(inside.y, inside.z)) / extent.w, 0.0, 1.0);
    }
    return left;
}

vec3 environment_transmittance(vec3 p) {
    vec3 sum = vec3(0.0);
    for (int i = 0; i < environment_count; ++i)
        sum += environment_weights[i] * media_transmittance(p, environment_directions[i].xyz, 0.0, kEnvironmentFar);
    return sum;
}

// What medium i scatters of it at p to the eye, whose ray has this direction: radiance per metre and scattering coefficient.
vec3 environment_scattered(int i, vec3 p, vec3 direction) {
    Sh9 harmonics;
    for (int k = 0; k < 9; ++k) harmonics.c[k] = environment_harmonics[k];
    vec3 bands = environment_bands[i];
    return max(sh9_sum(harmonics, environment_image_from_world * direction, bands.x, bands.y, bands.z), vec3(0.0));
}
