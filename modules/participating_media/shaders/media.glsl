// All media of the frame, and what they do along a straight line. Same structs in media_buffer.cpp.
//
// What no medium of the frame has is not compiled (media_kinds.glsl): software renderers execute both sides of a branch, and the
// body of a loop once more than it has turns, a loop of none too. ONE_MEDIUM says that there is one, NO_MEDIA that there is none,
// EVEN_MEDIA that no density varies: what lies in a uniform block at a known place is much faster to read there.
#include "participating_media/media_kinds.glsl"
#include "physics/black_body.glsl"
#include "physics/intersect.glsl"
#include "physics/noise.glsl"
#include "physics/phase.glsl"
#include "physics/ramp.glsl"
#include "physics/transmittance.glsl"

struct GpuMedium {
    mat4 box_from_world;    // to the box [-1/2, 1/2]^3
    vec4 sigma_s_phase;     // rgb 1/m of what is scattered, times the artist's factor; w PHASE_...
    vec4 sigma_t;           // rgb 1/m
    vec4 phase_parameters;
    vec4 emission_even;     // rgb cd/m2 per metre, w 1 when the density is 1 everywhere
    vec4 blobs_height;      // x first blob, y end of blobs, z height density: base in metres, w 1 / scale height, or 0
    vec4 sampled;           // x octaves of noise or 0, y its coverage, z grid: scale or 0, w its first layer in the atlas
    vec4 grid_size;         // xyz voxels
    mat4 field_from_world;  // to features of the noise, or to [0, 1]^3 over the grid
    vec4 noise;             // x NOISE_..., y swirl, z churn by now, w 1 / feature size in metres
    vec4 ramp_from;         // gradient in the box: xyz from or centre, w 0 none, 1 linear, 2 radial
    vec4 ramp_to;           // xyz to, or x inner and y outer radius; w unused
    vec4 ramp_ends;         // x density at the start, y at the end
    vec4 shape;             // x 1 for an ellipsoid, y 1 when mask or layer multiply the rest, z layer: base, w 1 / scale height, or 0
    vec4 mask_size;         // xyz voxels, 0 = no mask; w first layer in the atlas
    mat4 mask_from_world;   // to [0, 1]^3 over the mask
    vec4 temperature_size;  // xyz voxels, 0 = no grid; w first layer in the atlas
    vec4 temperature;       // x kelvin per unit, y kelvin added; zw unused
    vec4 sigma_a;           // rgb 1/m
    mat4 temperature_from_world;
};

layout(std140) uniform Media { GpuMedium media[16]; };
layout(std140) uniform MediaBlobs {
    vec4 blob_centre_radius[64];  // in the medium's box
    vec4 blob_weight[64];         // x
};
#if defined(ONE_MEDIUM)
const int media_count = 1;
#elif defined(NO_MEDIA)
const int media_count = 0;
#else
uniform int media_count;
#endif
uniform int media_light_steps;  // samples on the way through noise and grids
uniform sampler3D media_grids;  // voxels of all grids, stacked along z
uniform vec3 media_grids_voxel;  // 1 / its size
// Where in their steps samples along a line are taken: solvers that average over pixels set it to noise.
float media_sample_offset = 0.5;

vec3 medium_place(int i, vec3 p) { return (media[i].box_from_world * vec4(p, 1.0)).xyz; }

// The part of the ray inside medium i; t in metres, since the direction is carried over unnormalised.
bool clip_to_medium(int i, vec3 origin, vec3 direction, inout float t0, inout float t1) {
    vec3 o = medium_place(i, origin);
    vec3 d = mat3(media[i].box_from_world) * direction;
    vec3 inverse = 1.0 / mix(d, vec3(1e-20), lessThan(abs(d), vec3(1e-20)));
    vec3 a = (-0.5 - o) * inverse;
    vec3 b = (0.5 - o) * inverse;
    vec3 near = min(a, b), far = max(a, b);
    t0 = max(t0, max(near.x, max(near.y, near.z)));
    t1 = min(t1, min(far.x, min(far.y, far.z)));
    bool inside = t0 < t1;
#ifdef MEDIA_ELLIPSOIDS
    if (media[i].shape.x > 0.0) inside = clip_to_unit_ball(o, d, t0, t1) && inside;
#endif
    return inside;
}

// A grid's value at a place in [0, 1]^3 over it; 0 outside. `size` as in mask_size.
float grid_value(vec3 place, vec4 size) {
    bool inside = all(greaterThanEqual(place, vec3(0.0))) && all(lessThanEqual(place, vec3(1.0)));
    vec3 texel = clamp(place * size.xyz, vec3(0.5), size.xyz - 0.5) + vec3(0.0, 0.0, size.w);
    return inside ? textureLod(media_grids, texel * media_grids_voxel, 0.0).r : 0.0;
}

#ifndef EVEN_MEDIA
// Noise, grids and gradients: what has no closed form along a line. What of noise is finer than samples `spacing` metres
// apart fades into its mean. `place` is field_from_world of p: along a line it grows by equal steps.
float sampled_density(int i, vec3 p, vec3 place, float spacing) {
    float density = 0.0;
#ifdef MEDIA_NOISE
    if (media[i].sampled.x > 0.0) {
        if (media[i].noise.y > 0.0)
            place += media[i].noise.y * noise_swirl(place, media[i].noise.z);
        density += filtered_noise_density(place, int(media[i].noise.x), int(media[i].sampled.x), media[i].sampled.y,
                                          spacing * media[i].noise.w);
    }
#endif
#ifdef MEDIA_GRIDS
    if (media[i].grid_size.x > 0.0)
        density += media[i].sampled.z * grid_value(place, vec4(media[i].grid_size.xyz, media[i].sampled.w));
#endif
#ifdef MEDIA_RAMPS
    if (media[i].ramp_from.w > 0.0) {
        vec3 local = medium_place(i, p);
        float at = media[i].ramp_from.w > 1.5 ? radial_ramp(local, media[i].ramp_from.xyz, media[i].ramp_to.x, media[i].ramp_to.y)
                                              : linear_ramp(local, media[i].ramp_from.xyz, media[i].ramp_to.xyz);
        density += mix(media[i].ramp_ends.x, media[i].ramp_ends.y, at);
    }
#endif
    return density;
}

// Constant, blobs and height: what has a closed form along a line.
float closed_density(int i, vec3 p) {
    float density = media[i].emission_even.w;
#ifdef MEDIA_BLOBS
    vec3 local = medium_place(i, p);
    for (int b = int(media[i].blobs_height.x); b < int(media[i].blobs_height.y); ++b) {
        vec3 away = local - blob_centre_radius[b].xyz;
        float radius = blob_centre_radius[b].w;
        density += blob_weight[b].x * exp(-0.5 * dot(away, away) / (radius * radius));
    }
#endif
#ifdef MEDIA_HEIGHT
    float per_metre = media[i].blobs_height.w;
    density += per_metre > 0.0 ? height_density(p.y, media[i].blobs_height.z, 1.0 / per_metre) : 0.0;
#endif
    return density;
}

// What the medium's mask and layer leave of its density.
float density_share(int i, vec3 p) {
    float share = 1.0;
    if (media[i].mask_size.x > 0.0) share *= grid_value((media[i].mask_from_world * vec4(p, 1.0)).xyz, media[i].mask_size);
    if (media[i].shape.w > 0.0) share *= height_density(p.y, media[i].shape.z, 1.0 / media[i].shape.w);
    return share;
}

// Density of medium i at a place inside its box, for samples `spacing` metres apart; 0 for the density itself.
float medium_density(int i, vec3 p, float spacing) {
    float density = closed_density(i, p) + sampled_density(i, p, (media[i].field_from_world * vec4(p, 1.0)).xyz, spacing);
#ifdef MEDIA_PRODUCTS
    if (media[i].shape.y > 0.0) density *= density_share(i, p);
#endif
    return density;
}

// Whether anything of medium i has no closed form along a line: noise, grids, gradients, and all that mask and layer multiply.
bool medium_uneven(int i) {
    return media[i].shape.y + media[i].sampled.x + media[i].grid_size.x + media[i].ramp_from.w > 0.0;
}

// Integral of the density along [t0, t1] inside medium i's box, metres: the part that has a closed form.
float closed_column(int i, vec3 origin, vec3 direction, float t0, float t1) {
    float ds = t1 - t0;
    float column = media[i].emission_even.w * ds;
#ifdef MEDIA_BLOBS
    for (int b = int(media[i].blobs_height.x); b < int(media[i].blobs_height.y); ++b)
        column += blob_weight[b].x * gaussian_line_integral(medium_place(i, origin), mat3(media[i].box_from_world) * direction,
                                                            blob_centre_radius[b].xyz, blob_centre_radius[b].w, t0, t1);
#endif
#ifdef MEDIA_HEIGHT
    float per_metre = media[i].blobs_height.w;
    column += per_metre > 0.0 ? height_fog_optical_depth(1.0, media[i].blobs_height.z, 1.0 / per_metre, origin.y + t0 * direction.y,
                                                         origin.y + t1 * direction.y, ds) : 0.0;
#endif
    return media[i].shape.y > 0.0 ? 0.0 : column;  // mask and layer multiply: nothing has a closed form
}

// The rest, taken `samples` times, to where nothing more comes through (e^-12).
float sampled_column(int i, vec3 origin, vec3 direction, float t0, float t1, int samples) {
    if (t0 >= t1 || !medium_uneven(i)) return 0.0;
    float column = 0.0;
    float step_m = (t1 - t0) / float(samples);
    mat4 field = media[i].field_from_world;
    vec3 place = (field * vec4(origin + direction * (t0 + media_sample_offset * step_m), 1.0)).xyz;
    vec3 place_step = mat3(field) * direction * step_m;
    vec3 sigma_t = media[i].sigma_t.rgb;
    float enough = 12.0 / max(min(sigma_t.r, min(sigma_t.g, sigma_t.b)), 1e-6);
    int s = 0;
    do {
        vec3 p = origin + direction * (t0 + (float(s) + media_sample_offset) * step_m);
        float density = sampled_density(i, p, place + float(s) * place_step, step_m);
#ifdef MEDIA_PRODUCTS
        if (media[i].shape.y > 0.0) density = (density + closed_density(i, p)) * density_share(i, p);
#endif
        column += density * step_m;
    } while (++s < samples && column < enough);
    return column;
}
#else
float medium_density(int i, vec3 p, float spacing) { return 1.0; }
bool medium_uneven(int i) { return false; }
float closed_column(int i, vec3 origin, vec3 direction, float t0, float t1) { return t1 - t0; }
float sampled_column(int i, vec3 origin, vec3 direction, float t0, float t1, int samples) { return 0.0; }
#endif
// Integral of the density along [t0, t1] inside medium i's box, metres.
float medium_column(int i, vec3 origin, vec3 direction, float t0, float t1, int samples) {
    return closed_column(i, origin, direction, t0, t1) + sampled_column(i, origin, direction, t0, t1, samples);
}
float medium_density(int i, vec3 p) { return medium_density(i, p, 0.0); }

// Radiance that medium i gives off per metre where its density is 1.
vec3 medium_emission(int i, vec3 p) {
    vec3 emission = media[i].emission_even.rgb;
    if (media[i].temperature_size.x > 0.0) {
        float kelvin = media[i].temperature.y + media[i].temperature.x * grid_value((media[i].temperature_from_world * vec4(p, 1.0)).xyz,
                                                                                     media[i].temperature_size);
        emission += media[i].sigma_a.rgb * black_body_radiance(kelvin);
    }
    return emission;
}

// What of the media's densities counts: all, what has a closed form along a line, or what has none.
const int MEDIA_ALL = 3, MEDIA_OF_CLOSED_FORM = 1, MEDIA_OF_NONE = 2;

// Optical depth of all media between two distances on the ray. `parts` is a constant, one of the above.
vec3 media_optical_depth(int parts, vec3 origin, vec3 direction, float t_begin, float t_end, int samples) {
    vec3 depth = vec3(0.0);
    for (int i = 0; i < media_count; ++i) {
        float t0 = t_begin, t1 = t_end;
        bool inside = clip_to_medium(i, origin, direction, t0, t1);
        t1 = inside ? t1 : t0;
        float column = 0.0;
        if ((parts & MEDIA_OF_CLOSED_FORM) != 0) column += closed_column(i, origin, direction, t0, t1);
        if ((parts & MEDIA_OF_NONE) != 0) column += sampled_column(i, origin, direction, t0, t1, samples);
        depth += media[i].sigma_t.rgb * column;
    }
    return depth;
}
vec3 media_optical_depth(vec3 origin, vec3 direction, float t_begin, float t_end, int samples) {
    return media_optical_depth(MEDIA_ALL, origin, direction, t_begin, t_end, samples);
}
vec3 media_closed_depth(vec3 origin, vec3 direction, float t_begin, float t_end) {
    return media_optical_depth(MEDIA_OF_CLOSED_FORM, origin, direction, t_begin, t_end, 1);
}
vec3 media_uneven_depth(vec3 origin, vec3 direction, float t_begin, float t_end, int samples) {
    return media_optical_depth(MEDIA_OF_NONE, origin, direction, t_begin, t_end, samples);
}

// Share of the light that passes all media between two distances on the ray.
vec3 media_transmittance(vec3 origin, vec3 direction, float t_begin, float t_end) {
    return exp(-media_optical_depth(origin, direction, t_begin, t_end, media_light_steps));
}
