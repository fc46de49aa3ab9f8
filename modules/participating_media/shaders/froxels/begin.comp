// Begins a frame's froxels: what of their history still holds, to which the lights add.
//
// A froxel's source is the radiance per metre that goes to the eye, a mean over the froxel. Its alpha is 1 + the weight of this
// frame's light, or 0 where nobody looks: the sum over n frames is their mean until the weight is down to `least_weight`. A negative
// alpha is of a froxel that stands in for a place that cannot be seen; nothing is remembered of it.
#include "participating_media/froxels/grid.glsl"

// HISTORY: 0 none, 1 from another view, 2 from the same, in place.
layout(local_size_x = 8, local_size_y = 8) in;

layout(rgba32f) uniform image3D froxel_source;
layout(rg32f) readonly uniform image2D froxel_reach;
uniform sampler3D history;     // the last frame's froxel_source
uniform vec4 history_depths;   // as froxel_depths, of the last frame
uniform mat4 history_view_projection;
uniform vec3 history_eye;
uniform float least_weight;
uniform int dirty_count;       // places where the light changed, at least one
uniform vec4 dirty[16];        // centre and radius; a negative radius is everywhere

// How fast the history fades when the eye sees a place from another side: the phase function's lobe moves.
const float kFadePerRadian = 8.0;
// And when it lies between froxels, where it is interpolated once more: shafts would blur from frame to frame.
const float kFadeBetween = 4.0;

vec4 reprojected(vec3 p, out float between) {
    vec4 clip = history_view_projection * vec4(p, 1.0);
    vec2 uv = clip.xy / clip.w * 0.5 + 0.5;
    float share = log(1.0 + max(clip.w - history_depths.x, 0.0) / history_depths.y) / history_depths.z;
    vec3 place = vec3(uv, share);
    vec3 f = fract(place * vec3(froxel_size) - 0.5);
    vec3 mixed = 4.0 * f * (1.0 - f);
    between = max(mixed.x, mixed.y);
    bool inside = clip.w > history_depths.x && all(greaterThanEqual(place, vec3(0.0))) && all(lessThanEqual(place, vec3(1.0)));
    return inside ? textureLod(history, froxel_place(place), 0.0) : vec4(0.0);
}

// What the froxel remembers, and how much of it is forgotten.
vec4 remembered(ivec3 froxel, vec3 middle, out float faded) {
#if HISTORY == 1
    float between;
    vec4 old = reprojected(middle, between);
    float angle = length(normalize(middle - frame.eye_near.xyz) - normalize(middle - history_eye));
    faded = max(kFadePerRadian * angle, kFadeBetween * between);
    return old;
#else
    faded = 0.0;
    return imageLoad(froxel_source, froxel_place(froxel));
#endif
}

bool is_dirty(vec3 p) {
    bool found = false;
    int i = 0;
    do found = found || dirty[i].w < 0.0 || distance(p, dirty[i].xyz) < dirty[i].w;
    while (++i < dirty_count);
    return found;
}

// What a froxel begins with that nothing is remembered of. `reach` as in reach.comp.
vec4 fresh(float near, vec2 reach) { return vec4(0.0, 0.0, 0.0, near < reach.y ? 2.0 : near < reach.x ? -2.0 : 0.0); }

void main() {
    ivec3 froxel = ivec3(gl_GlobalInvocationID) * ivec3(1, 1, slices_a_thread);
    if (any(greaterThanEqual(froxel, froxel_size))) return;
    int end = min(froxel.z + slices_a_thread, froxel_size.z);
    vec2 reach = imageLoad(froxel_reach, froxel.xy).xy;
    vec3 to_plane = eye_ray_to_plane((vec2(froxel.xy) + 0.5) / vec2(froxel_size.xy));
    float near = froxel_depth(float(froxel.z) / float(froxel_size.z));
    do {
        vec4 source = fresh(near, reach);
#if HISTORY != 0
        vec3 middle = frame.eye_near.xyz + froxel_middle(near) * to_plane;
        float faded;
        vec4 old = remembered(froxel, middle, faded);
        float before = old.a - 1.0;
        float weight = min(max(max(before / (1.0 + before), least_weight), faded), 1.0);
        bool holds = near < reach.y && old.a >= 1.0 && !is_dirty(middle);
        source = holds ? vec4(old.rgb * (1.0 - weight), 1.0 + weight) : source;
#endif
        imageStore(froxel_source, froxel_place(froxel), source);
        near = froxel_end(near);
    } while (++froxel.z < end);
}
