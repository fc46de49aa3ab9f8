// Puts together what the views' maps know of each pixel's place, and writes what makes the base look as the light that
// leaves does.
//
// A texel of a map counts by how near its place is to the pixel's, and by how straight its view sees it. Nothing has to
// be moved or shrunk: where a view does not see the place, its texels are far away. Where no view sees it, the nearest win.
#include "render/shaders/frame.glsl"
#include "render/shaders/gbuffer.glsl"
#include "translucency/interior.glsl"
#include "translucency/radiance_maps/layers.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
uniform sampler2D scene_depth;
uniform sampler2D gbuffer_normal;
uniform sampler2D gbuffer_surface;
#ifdef AROUND
uniform sampler2D around;  // irradiance from all around; a: 1 where it is known
#endif
uniform sampler2DArray places;
uniform sampler2DArray leaving;
layout(rgba32f) writeonly uniform image2D light_diffuse;
const int kMaxViews = 64;
layout(std140) uniform Views { vec4 views[3 * kMaxViews]; };  // u, v, toward the camera and the map's side
uniform int view_count;
uniform int resolution;
uniform int samples;
uniform int frames;
uniform mat4 body_from_world;
uniform float number;
uniform ivec2 low;  // pixels

/// Below this cosine a view does not count.
const float kLeastCosine = 0.1;
/// How near texels must be, in their own size over the cosine.
const float kNear = 1.5;

/// Adds a view's four texels about the place.
void add_view(int view, vec3 place, float cosine, int level, inout vec4 sum, inout float weights) {
    int size = resolution >> level;
    vec2 uv = vec2(dot(views[3 * view], vec4(place, 1.0)), dot(views[3 * view + 1], vec4(place, 1.0)));
    vec2 at = uv * float(size) - 0.5;
    vec2 base = floor(at), part = at - base;
    float texel = views[3 * view + 2].w / float(size) * kNear / cosine;
    float straight = (cosine - kLeastCosine) * (cosine - kLeastCosine);
    for (int i = 0; i < 4; ++i) {
        ivec2 corner = ivec2(i & 1, i >> 1);
        ivec3 fetched = ivec3(clamp(ivec2(base) + corner, ivec2(0), ivec2(size - 1)), view);
        vec4 seen = texelFetch(places, fetched, level);
        vec3 apart = (seen.xyz - place) / texel;
        float far = dot(apart, apart);
        far *= far;
        vec2 share = mix(1.0 - part, part, vec2(corner));
        float weight = seen.w > 0.0 ? straight * max(share.x * share.y, 1e-4) / (1.0 + far * far) : 0.0;
        sum += weight * texelFetch(leaving, fetched, level);
        weights += weight;
    }
}

/// As few samples have been gathered, the maps are looked at more coarsely; at the end as they are.
float level_of_samples() {
    const float kBlurred = 64.0;  // up to so many of a texel
    float coarsest = clamp(log2(float(resolution) / 32.0), 0.0, 2.0);  // where details would be lost
    if (state.gathered_frames >= uint(frames)) return 0.0;
    float all = float(frames * samples), now = float(state.gathered_frames) * float(samples);
    return coarsest * (1.0 - log2(max(now / kBlurred, 1.0)) / log2(max(all / kBlurred, 2.0)));
}

vec4 leaving_of_level(vec3 place, vec3 normal, int level) {
    vec4 sum = vec4(0.0);
    float weights = 0.0;
    int view = 0;
    do {  // two loops, since processors skip nothing but by a loop
        float cosine;
        do cosine = dot(views[3 * view + 2].xyz, normal);
        while (cosine <= kLeastCosine && ++view < view_count);
        if (view < view_count) add_view(view, place, cosine, level, sum, weights);
    } while (++view < view_count);
    return sum / max(weights, 1e-30);
}

vec4 leaving_at(vec3 place, vec3 normal) {
    float level = clamp(level_of_samples(), 0.0, 2.0);
    int fine = int(level), last = int(ceil(level));
    float part = level - float(fine);
    vec4 sum = vec4(0.0);
    int i = fine;
    do sum += (i == fine ? 1.0 - part : part) * leaving_of_level(place, normal, i);
    while (++i <= last);
    return sum;
}

/// What the kernel says that leaves of light that is even all around.
vec3 kernel_integral() {
    vec3 sum = vec3(0.0);
    for (int k = 0; k < kKernelGaussians; ++k)
        sum += interior.kernel[k].rgb * (kPi / ldexp(interior.kernel_rate.x, kKernelGaussians - 1 - k));
    return sum;
}

void main() {
    ivec2 pixel = low + ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, ivec2(frame.size_time.xy)))) return;
    if (surface_number(texelFetch(gbuffer_surface, pixel, 0)) != number) return;
#ifdef AROUND
    vec4 surroundings = texelFetch(around, pixel, 0);
    if (surroundings.a == 0.0) return;
#endif
    vec2 uv = (vec2(pixel) + 0.5) / frame.size_time.xy;
    vec3 place = world_from_depth(uv, texelFetch(scene_depth, pixel, 0).x);
    vec3 normal = decode_lit_point(texelFetch(gbuffer_normal, pixel, 0)).normal;
    float cosine = standard_nov(normal, -eye_ray(uv));
    vec3 body_normal = normalize(mat3(body_from_world) * normal);
    vec4 leaves = layer_count > 0 ? leaving_at((body_from_world * vec4(place, 1.0)).xyz, body_normal) : vec4(0.0);
    float deep = clamp(leaves.a / max(luminance_rec709(leaves.rgb), 1e-30), 0.0, 1.0);
    vec3 near = near_pattern(cosine);
    vec3 even = vec3(0.0);
#ifdef AROUND
    even = surroundings.rgb * mean_entering() * mean_leaving() * leaves_where_it_enters(place);
    if (interior.boundary.z == 0.0) even *= kernel_integral();
#endif
    // The compose pass multiplies by the base and by what the mirror lets through, which is how light passes outward.
    vec3 scale = 1.0 / (max(interior.base_entering.rgb, vec3(1e-4)) * mean_entering());
    imageStore(light_diffuse, pixel, vec4(scale * (mix(near, deep_pattern(cosine), deep) * leaves.rgb + near * even), 0.0));
}
