// Single scattering of one light in one medium, along the rays of the samples that are looked at.
//
// What the ray would get without shadows is summed up in STEPS steps; the lit stretches are then found by walking along
// the shadow map's line, in strides as long as the tree says that all is lit or all is dark (Yusov 2013), and each takes
// its part of the sum. A ray's depth in the shadow map is linear along the line, so the ends of stretches are exact
// within a texel of the line.
#include "participating_media/light_source.glsl"

layout(local_size_x = 64) in;

uniform int slices;
uniform int samples;
uniform int shadow_samples;
uniform int shadow_view_index;  // negative: nothing casts shadows
uniform int coarsest;           // level; 0 walks texel by texel: the reference for the tree
layout(rgba32f) uniform readonly image2D slice_ends;
layout(r32f) uniform readonly image2D distances;
layout(rg32f) uniform readonly image2D sources;
layout(rg32f) uniform readonly image2D tree;
layout(rgba32f) uniform writeonly image2D looks;

vec3 sums[STEPS + 1];  // up to the end of each step
float low, high;       // of the curve that is cut into equal steps: metres, or the angle seen from the light
float closest, passing;

float curve(float t) { return LIGHT_KIND == 2 ? t : atan((t - closest) / passing); }

void sum_up(Ray ray, float t0, float t1) {
    vec3 to_light = light_position(light_index) - ray.origin;
    closest = dot(to_light, ray.direction);
    passing = max(length(to_light - closest * ray.direction), 1e-3);
    low = curve(t0);
    high = curve(t1);
    vec3 before = media_transmittance(ray.origin, ray.direction, 0.0, t0);
    sums[0] = vec3(0.0);
    float begin = t0;
    for (int i = 0; i < STEPS; ++i) {
        float v = mix(low, high, float(i + 1) / float(STEPS));
        float end = LIGHT_KIND == 2 ? v : clamp(closest + passing * tan(v), begin, t1);
        float v_middle = mix(low, high, (float(i) + 0.5) / float(STEPS));
        float middle = LIGHT_KIND == 2 ? v_middle : clamp(closest + passing * tan(v_middle), begin, end);
        float offset = middle - closest;
        // the integral of 1/d^2 over equal angles is their number; `source` has 1/d^2 at the middle in it
        float metres = LIGHT_KIND == 2 ? end - begin : (passing + offset * offset / passing) * (high - low) / float(STEPS);
        vec3 step_depth = media_optical_depth(ray.origin, ray.direction, begin, end, 1);
        sums[i + 1] = sums[i] + source(ray, middle) * before * mean_transmittance(step_depth) * metres;
        before *= exp(-step_depth);
        begin = end;
    }
}

vec3 sum_at(float t) {
    float at = clamp((curve(t) - low) / max(high - low, 1e-9), 0.0, 1.0) * float(STEPS);
    int i = min(int(at), STEPS - 1);
    return mix(sums[i], sums[i + 1], at - float(i));
}

// The ray in the shadow map, with a parameter from 0 to 1 in which place and depth are linear.
struct Track {
    float cell0, cells;  // along the line, in its samples; never falls
    float z0, dz;        // depth
    float t0, dt;        // of the ray, metres, at 0 and to 1
    float w0, dw;        // of the projection, at the ray's t = 0 and for a metre
};

Track make_track(Ray ray, float t0, float t1, vec4 line) {
    mat4 page = light_data(light_index).views[shadow_view_index].page_from_world;
    vec4 a = page * vec4(ray.origin, 1.0);
    vec4 b = page * vec4(ray.direction, 0.0);
    vec4 begin = a + t0 * b, end = a + t1 * b;
    vec2 along = line.zw - line.xy;
    along *= float(shadow_samples) / max(dot(along, along), 1e-12);
    float from = dot(begin.xy / begin.w - line.xy, along);
    float to = dot(end.xy / end.w - line.xy, along);
    float z0 = begin.z / begin.w, z1 = end.z / end.w;
    return to >= from ? Track(from, to - from, z0, z1 - z0, t0, t1 - t0, a.w, b.w)
                      : Track(to, from - to, z1, z0 - z1, t1, t0 - t1, a.w, b.w);
}

float metres_at(Track track, float s) {
    float w1 = track.w0 + (track.t0 + track.dt) * track.dw;
    return (track.t0 * w1 + s * track.dt * track.w0) / (w1 - s * track.dt * track.dw);
}

vec3 lit_sum(Track track) {
    vec3 sum = vec3(0.0);
    vec2 stretch = vec2(0.0);  // lit, not yet summed
    float here = 0.0;
    float per_cell = 1.0 / max(track.cells, 1e-6);
    if (track.cell0 < 0.0) {  // not on the map: lit
        here = clamp(-track.cell0 * per_cell, 0.0, 1.0);
        stretch = vec2(0.0, here);
    }
    int cell = clamp(int(floor(track.cell0)), 0, shadow_samples - 1);
    int whole = 2 * shadow_samples;
    int level = 0;
    while (here < 1.0 && cell < shadow_samples) {
        float next = min((float(cell + (1 << level)) - track.cell0) * per_cell, 1.0);
        vec2 depths = imageLoad(tree, ivec2(gl_GlobalInvocationID.x, whole - (whole >> level) + (cell >> level))).rg;
        float za = track.z0 + here * track.dz, zb = track.z0 + next * track.dz;
        bool lit = min(za, zb) >= depths.y;
        bool dark = max(za, zb) < depths.x;
        if (!lit && !dark && level > 0) {
            --level;
            continue;
        }
        vec2 part = vec2(here, next);
        if (!lit) {  // in one texel: up to where the ray's depth is the map's
            float crossing = (depths.x - track.z0) / (abs(track.dz) > 1e-12 ? track.dz : 1e-12);
            part = track.dz > 0.0 ? vec2(clamp(crossing, here, next), next) : vec2(here, clamp(crossing, here, next));
            if (dark) part = vec2(next);
        }
        if (part.y > part.x) {
            if (part.x > stretch.y + 1e-7) {
                sum += sum_at(metres_at(track, stretch.y)) - sum_at(metres_at(track, stretch.x));
                stretch.x = part.x;
            }
            stretch.y = part.y;
        }
        cell += 1 << level;
        here = next;
        if (level < coarsest && (cell & ((2 << level) - 1)) == 0) ++level;
    }
    if (here < 1.0) {  // beyond the map: lit
        if (stretch.y < here) {
            sum += sum_at(metres_at(track, stretch.y)) - sum_at(metres_at(track, stretch.x));
            stretch.x = here;
        }
        stretch.y = 1.0;
    }
    sum += sum_at(metres_at(track, stretch.y)) - sum_at(metres_at(track, stretch.x));
    return track.dt > 0.0 ? sum : -sum;
}

void main() {
    ivec2 at = ivec2(gl_GlobalInvocationID.xy);  // slice, sample
    if (at.x >= slices) return;
    float t1 = imageLoad(distances, at).r;
    if (t1 < 0.0 || imageLoad(sources, at).r != float(at.y)) return;
    vec4 ends = imageLoad(slice_ends, ivec2(at.x, 0));
    vec2 pixel = mix(ends.xy, ends.zw, float(at.y) / float(samples - 1));
    Ray ray = Ray(frame.eye_near.xyz, eye_ray(pixel / frame.size_time.xy));
    float t0 = 0.0;
    vec3 sum = vec3(0.0);
    if (clip_to_medium(medium, ray.origin, ray.direction, t0, t1) &&
        light_segment(light_index, ray.origin, ray.direction, t0, t1)) {
        sum_up(ray, t0, t1);
        vec4 line = imageLoad(slice_ends, ivec2(at.x, 1));
        bool shadowed = shadow_view_index >= 0 && line.xy != line.zw;
        sum = shadowed ? lit_sum(make_track(ray, t0, t1, line)) : sums[STEPS];
    }
    imageStore(looks, at, vec4(media[medium].sigma_s_phase.rgb * sum, 0.0));
}
