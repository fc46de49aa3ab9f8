// Adds one light's share to the froxels' source.
//
// A thread follows a ray through its slices: what depends on the ray alone is found once, and where the ray is outside of the
// light's volume nothing is looked at.
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
    vec3 sum = vec3(0.0);
    for (int k = 0; k < (t0 < t1 ? once : 0); ++k) {
        float t = mix(t0, t1, along);
        vec3 p = lit.ray.origin + t * lit.ray.direction;
        vec3 to_light;
        vec3 irradiance = light_irradiance(light_index, p, to_light) * near_light(lit, t0, t1, t);
        sum += irradiance * scattering(p, dot(to_light, lit.ray.direction), t1 - t0) * light_transmittance(light_index, p, vec3(0.0)) *
               ((t1 - t0) / (stretch.y - stretch.x));
    }
    return sum;
}

void main() {
    ivec3 first = ivec3(gl_GlobalInvocationID) * ivec3(1, 1, kSlicesAThread);
    if (any(greaterThanEqual(first, box_size))) return;
    int slices = min(kSlicesAThread, box_size.z - first.z);
    first += box_low;
    vec4 column = imageLoad(froxel_columns, first.xy);
    float dither = froxel_dither(first);
    float begin = froxel_depth(float(first.z) / float(froxel_size.z));
    int rays = samples;
    for (int i = 0; i < rays; ++i) {
        FroxelRay ray = froxel_ray(first, column, i);
        float z0 = begin;
        int k = 0;
        for (int r = 0; r < 2 * once && k < slices; ++r) {
            LitRay lit = lit_ray(ray);
            for (; k < slices && (z0 <= ray.surface || r == 1); ++k) {
                ivec3 index = froxel_place(first + ivec3(0, 0, k));
                float z1 = froxel_end(z0);
                vec4 froxel = imageLoad(froxel_source, index);
                int count = froxel_samples(froxel.a);
                rays = max(rays, count);
                vec2 stretch = froxel_stretch(ray, z0, z1);
                stretch.y = i < count ? stretch.y : 0.0;
                froxel.rgb += froxel_weight(froxel.a) / float(max(count, 1)) * source(lit, stretch, froxel_along(dither, k, i, count));
                imageStore(froxel_source, index, froxel);
                z0 = z1;
            }
            ray = froxel_ray(column.yz, column.x);
        }
    }
}
