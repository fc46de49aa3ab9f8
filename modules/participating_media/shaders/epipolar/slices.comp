// The two ends of each slice on the screen, and of the line that its plane cuts through the shadow map.
#include "participating_media/epipolar/lines.glsl"
#include "render/shaders/frame.glsl"
#include "render/shaders/lights.glsl"

layout(local_size_x = 64) in;

uniform vec2 epipole;  // the light's place, pixels
uniform int slices;
uniform int shadow_view_index;
layout(rgba32f) uniform writeonly image2D slice_ends;  // row 0: pixels from, to; row 1: shadow map's uv from, to

void main() {
    int slice = int(gl_GlobalInvocationID.x);
    if (slice >= slices) return;
    vec2 size = frame.size_time.xy;
    vec2 to = border_place(float(slice) * 4.0 / float(slices), size);
    vec2 inside = inside_picture(epipole, to, size);
    vec2 from = epipole + max(inside.x, 0.0) * (to - epipole);
    if (abs(inside.y - 1.0) > 1e-4 || distance(from, to) < 0.5) from = to;  // the end faces the light
    imageStore(slice_ends, ivec2(slice, 0), vec4(from, to));

    // Through the projections of two points of the ray, one of them at infinity.
    ShadowView view = light_data(0u).views[shadow_view_index];
    vec4 a = view.page_from_world * vec4(frame.eye_near.xyz, 1.0);
    vec4 b = view.page_from_world * vec4(eye_ray(to / size), 0.0);
    vec3 line = cross(a.xyw, b.xyw);
    line /= max(length(line.xy), 1e-20);
    vec2 centre = 0.5 * (view.rectangle.xy + view.rectangle.zw);
    vec2 foot = centre - line.xy * (dot(line.xy, centre) + line.z);
    vec2 along = vec2(-line.y, line.x);
    float t0 = -1e9, t1 = 1e9;
    bool meets = clip_to_slab(foot.x, along.x, view.rectangle.x, view.rectangle.z, t0, t1) &&
                 clip_to_slab(foot.y, along.y, view.rectangle.y, view.rectangle.w, t0, t1);
    imageStore(slice_ends, ivec2(slice, 1), meets ? vec4(foot + t0 * along, foot + t1 * along) : vec4(foot, foot));
}
