// A light's map of the uneven media's optical depth: a thread follows a ray away from the light.
//
// An opacity shadow map (Kim & Neumann 2001) holds what has gathered up to each of its planes; a Fourier opacity map (Jansen
// & Bavoil 2010) the coefficients of that function's series. Here the extinction is mirrored at the farthest plane: cosines
// alone are left, and nothing jumps from the end to the beginning, where the paper's series rings around a light in smoke.
#include "participating_media/media.glsl"
#include "participating_media/shadows/mapping.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

layout(rgba16f) writeonly uniform image3D shadow_map;
uniform int map_kind;
uniform vec3 map_origin;
uniform vec3 map_base;
uniform vec3 map_across;
uniform vec3 map_up;
uniform vec2 map_range;   // metres along the ray: near, far
uniform int map_size;     // texels
uniform int first_layer;
uniform int map_planes;   // of a Fourier map: stretches of the ray
uniform int map_samples;  // between two planes

void main() {
    ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(texel, ivec2(map_size)))) return;
    vec2 uv = (vec2(texel) + 0.5) / float(map_size);
    vec3 at = uv.x * map_across + uv.y * map_up;
    vec3 origin = map_origin + (map_kind == MAP_PARALLEL ? at : vec3(0.0));
    vec3 direction = map_base;
    if (map_kind == MAP_PYRAMID) direction = normalize(map_base + at);
    if (map_kind == MAP_OCTAHEDRON) direction = octahedron_fold((2.0 * vec2(texel) - vec2(map_size) + 1.0) / float(map_size - 2));
    float step_m = (map_range.y - map_range.x) / float(map_planes - 1);
    vec3 gathered = vec3(0.0);
#ifdef TERMS
    vec3 cosines[TERMS];
    for (int k = 0; k < TERMS; ++k) cosines[k] = vec3(0.0);
#else
    imageStore(shadow_map, ivec3(texel, first_layer), vec4(0.0));
#endif
    for (int plane = 1; plane < map_planes; ++plane) {
        float t = map_range.x + float(plane) * step_m;
        vec3 depth = media_uneven_depth(origin, direction, t - step_m, t, map_samples);
        gathered += depth;
#ifdef TERMS
        // the stretch's depth spread evenly over it: its middle's cosine times sinc of half its width; integrated, a sine
        float angle = kPi * (float(plane) - 0.5) / float(map_planes - 1);
        float width = 0.5 * kPi / float(map_planes - 1);
        for (int k = 0; k < TERMS; ++k) {
            float order = float(k + 1);
            cosines[k] += depth * (cos(order * angle) * sin(order * width) / (order * width) * 2.0 / (kPi * order));
        }
#else
        imageStore(shadow_map, ivec3(texel, first_layer + plane), vec4(gathered, 0.0));
#endif
    }
#ifdef TERMS
    imageStore(shadow_map, ivec3(texel, first_layer), vec4(gathered, 0.0));
    for (int k = 0; k < TERMS; ++k) imageStore(shadow_map, ivec3(texel, first_layer + k + 1), vec4(cosines[k], 0.0));
#endif
}
