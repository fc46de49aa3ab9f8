// Every way to draw surfaces starts here, so that passes that draw the same surface twice get the same depth.
#include "render/shaders/surfaces.glsl"

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec4 tangent;
layout(location = 3) in vec2 uv0;
layout(location = 4) in vec2 uv1;
layout(location = 5) in uint surface;  // one an instance
layout(location = 6) in float curvature;

uniform mat4 clip_from_world;

invariant gl_Position;

#if !defined(DEPTH_ONLY) || defined(ALPHA_MASK)
out vec4 v_uv;
#endif
#ifndef DEPTH_ONLY
out vec3 v_position;
out vec3 v_normal;
flat out float v_surface;  // number of the surface
out float v_curvature;     // 1/m
#ifdef NORMAL_MAP
out vec4 v_tangent;
#endif
#endif

void main() {
    vec4 world = surfaces[surface].world_from_local * vec4(position, 1.0);
    gl_Position = clip_from_world * world;
#if !defined(DEPTH_ONLY) || defined(ALPHA_MASK)
    v_uv = vec4(uv0, uv1);
#endif
#ifndef DEPTH_ONLY
    v_position = world.xyz;
    v_surface = surfaces[surface].normal_from_local[0].w;
    v_normal = mat3(surfaces[surface].normal_from_local[0].xyz, surfaces[surface].normal_from_local[1].xyz,
                    surfaces[surface].normal_from_local[2].xyz) * normal;
    v_curvature = curvature * length(v_normal);  // which is one over the scale
#ifdef NORMAL_MAP
    v_tangent = vec4(mat3(surfaces[surface].world_from_local) * tangent.xyz, tangent.w);
#endif
#endif
}
