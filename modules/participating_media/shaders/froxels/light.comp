// Adds one light's share to the froxels' source.
//
// A thread goes through the slices of its column that the light can reach. They are followed along one ray after another: what
// depends on the ray alone is found once, and where it is outside of the light's volume nothing is looked at.
#include "participating_media/froxels/sample.glsl"
#include "participating_media/scattering.glsl"
#include "render/shaders/lights.glsl"
#include "seams/light_transmittance.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

layout(rgba32f) uniform image3D froxel_source;
uniform uint light_index;
uniform ivec3 box_low;     // the froxels that the light reaches
uniform ivec3 box_size;
uniform uint light_media;  // those lit by it, a bit each

// A ray as the light sees it.
struct LitRay {
    FroxelRay ray;
    vec2 span;      // metres between which light and medium may be
    float closest;  // metres to the place nearest to the light
    float passing;  // metres between the two
};

LitRay lit_ray(FroxelRay ray) {
    LitRay lit = LitRay(ray, vec2(0.0, 1e6), 0.0, 1.0);
    bool meets = light_segment(light_index, ray.origin, ray.direction, lit.span.x, lit.span.y);
#ifdef ONE_MEDIUM
    meets = clip_to_medium(0, ray.origin, ray.direction, lit.span.x, lit.span.y) && meets;
#endif
    lit.span.y = meets ? lit.span.y : -1.0;
#if LIGHT_KIND != 2
    vec3 to_light = light_position(light_index) - ray.origin;
    lit.closest = dot(to_light, ray.direction);
    lit.passing = max(length(to_light - lit.closest * ray.direction), 1e-3);
#endif
    return lit;
}

// Mean of 1 / d^2 between t0 and t1, over 1 / d^2 at t. A froxel's width keeps the light from becoming a point.
float near_light(LitRay lit, float t0, float t1, float t) {
#if LIGHT_KIND == 2
    return 1.0;
#else
    float width = 2.0 * t * frame.tan_half_fov_exposure.y / float(froxel_size.y);
    float passing = max(lit.passing, 0.3 * width);
    float a = t0 - lit.closest, b = t1 - lit.closest, at = t - lit.closest;
    float angle = atan((b - a) * passing, passing * passing + a * b);
    return max(lit.passing * lit.passing + at * at, 1e-4) * angle / (passing * max(b - a, 1e-6));
#endif
}

// `spacing`: metres from a sample to the next.
vec3 scattering(vec3 p, float u, float spacing) {
#ifdef ONE_MEDIUM
    return media[0].sigma_s_phase.rgb * medium_density(0, p, spacing) * medium_phase(0, u);
#else
    vec3 sum = vec3(0.0);
    for (int i = 0; i < media_count; ++i) {
        bool inside = (light_media >> uint(i) & 1u) != 0u && medium_holds(i, p);
        sum += inside ? media[i].sigma_s_phase.rgb * medium_density(i, p, spacing) * medium_phase(i, u) : vec3(0.0);
    }
    return sum;
#endif
}

// Mean radiance per metre that goes to the eye from the stretch.
vec3 source(LitRay lit, vec2 stretch, float along) {
    float t0 = max(stretch.x, lit.span.x), t1 = min(stretch.y, lit.span.y);
    float t = mix(t0, t1, along);
    vec3 p = lit.ray.origin + t * lit.ray.direction;
    vec3 to_light;
    vec3 irradiance = light_irradiance(light_index, p, to_light) * near_light(lit, t0, t1, t);
    vec3 sum = irradiance * scattering(p, dot(to_light, lit.ray.direction), t1 - t0) * light_transmittance(light_index, p, vec3(0.0)) *
               ((t1 - t0) / (stretch.y - stretch.x));
    return t0 < t1 ? sum : vec3(0.0);
}

// Slices between two depths, as numbers from the grid's begin.
ivec2 slices_between(vec2 depths) {
    return ivec2(froxel_share(depths.x) * float(froxel_size.z), froxel_share(depths.y) * float(froxel_size.z));
}

// Depths between which the light can reach what the column's rays see, up to `reach`: along the ray through its middle, from
// which all others stay as near as `margin`.
vec2 lit_depths(ivec2 column, float surface, float reach) {
    vec3 to_plane = eye_ray_to_plane((vec2(column) + 0.5) / vec2(froxel_size.xy));
    float slope = length(to_plane), end = min(reach, froxel_depths.w);
    vec2 half_size = frame.tan_half_fov_exposure.xy * (1.0 / vec2(froxel_size.xy) + 2.0 / frame.size_time.xy);
    vec2 t = vec2(0.0, end * slope);
    bool meets = light_segment(light_index, frame.eye_near.xyz, to_plane / slope, end * length(half_size), t.x, t.y);
    // Where the light comes as far as the surface, it does the froxels that stand in for what is behind it.
    return meets ? vec2(t.x / slope, t.y >= surface * slope ? end : t.y / slope) : vec2(froxel_depths.x);
}

// The same of one ray; empty when nothing is left between two depths.
vec2 lit_depths(LitRay lit, float from, float to) {
    vec2 t = lit.span / lit.ray.slope;
    vec2 depths = vec2(max(t.x, from), t.y >= lit.ray.surface ? to : min(t.y, to));
    return depths.x < depths.y ? depths : vec2(1e6, -1e6);
}

void main() {
    ivec3 first = ivec3(gl_GlobalInvocationID) * ivec3(1, 1, slices_a_thread);
    if (any(greaterThanEqual(first, box_size))) return;
    int last = box_low.z + min(first.z + slices_a_thread, box_size.z) - 1;
    first += box_low;
    vec4 column = imageLoad(froxel_columns, first.xy);
    float reach = imageLoad(froxel_reach, first.xy).x;
    LitRay far = lit_ray(froxel_ray(column.yz, column.x));
    ivec2 lit = clamp(slices_between(lit_depths(first.xy, column.x, reach)), first.z, last);
    first.z += (lit.x - first.z) / kSlicesARay * kSlicesARay;
    // No loop of this takes zero turns: those cost one all the same on processors, where branches are not taken.
    do {
        float dither = froxel_dither(first);
        int rays = samples, i = 0;
        do {
            LitRay near = lit_ray(froxel_ray(first, column, i));
            vec2 before = lit_depths(near, 0.0, near.ray.surface), behind = lit_depths(far, near.ray.surface, reach);
            ivec2 slices = clamp(slices_between(vec2(min(before.x, behind.x), max(before.y, behind.y))), first.z,
                                 min(first.z + kSlicesARay - 1, lit.y));
            int k = slices.x;
            float z0 = froxel_depth(float(k) / float(froxel_size.z));
            do {
                ivec3 place = froxel_place(ivec3(first.xy, k));
                vec4 froxel = imageLoad(froxel_source, place);
                int count = froxel_samples(froxel.a);
                rays = max(rays, count);
                LitRay ray = near;
                if (z0 > near.ray.surface) ray = far;
                float z1 = froxel_end(z0);
                vec2 stretch = froxel_stretch(ray.ray, z0, z1);
                stretch.y = i < count ? stretch.y : 0.0;
                froxel.rgb += froxel_weight(froxel.a) / float(max(count, 1)) * source(ray, stretch, froxel_along(dither, k - first.z, i, count));
                imageStore(froxel_source, place, froxel);
                z0 = z1;
            } while (++k <= slices.y);
        } while (++i < rays);
        first.z += kSlicesARay;
    } while (first.z <= lit.y);
}
