// What every pass may know of the frame: FrameBlock of render/frame.h, and the way between pixels and the world.
//
// uv is 0..1 over the frame from its bottom left; depth is the reversed-Z depth buffer's, 0 where there is nothing.
layout(std140) uniform FrameBlock {
    mat4 view;
    mat4 projection;
    mat4 view_projection;
    mat4 inverse_view_projection;
    mat4 previous_view_projection;
    vec4 eye_near;               // eye in the world, near plane in metres
    vec4 size_time;              // width, height, seconds, frame number
    vec4 tan_half_fov_exposure;  // tan(fov/2) horizontal and vertical, exposure
} frame;

/// From the eye through uv to the plane 1 m in front of it; world space.
vec3 eye_ray_to_plane(vec2 uv) {
    return vec3((uv * 2.0 - 1.0) * frame.tan_half_fov_exposure.xy, -1.0) * mat3(frame.view);
}

/// Unit direction from the eye through uv.
vec3 eye_ray(vec2 uv) { return normalize(eye_ray_to_plane(uv)); }

/// Metres along the eye's axis.
float view_depth(float depth) { return frame.eye_near.w / depth; }

/// Metres from the eye to the surface at uv.
float eye_distance(vec2 uv, float depth) { return view_depth(depth) * length(eye_ray_to_plane(uv)); }

/// The surface point at uv.
vec3 world_from_depth(vec2 uv, float depth) { return frame.eye_near.xyz + view_depth(depth) * eye_ray_to_plane(uv); }

/// Metres that a pixel covers at p, across the line of sight.
float pixel_footprint(vec3 p) {
    return distance(p, frame.eye_near.xyz) * 2.0 * frame.tan_half_fov_exposure.y / frame.size_time.y;
}
