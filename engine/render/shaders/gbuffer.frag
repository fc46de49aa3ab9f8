// Fills the G-buffer; THIN: only what lights need.
#include "render/shaders/gbuffer.glsl"
#include "render/shaders/material.glsl"

flat in float v_surface;
in float v_curvature;
layout(location = 0) out vec4 gbuffer_normal;
layout(location = 1) out vec4 gbuffer_surface;
#ifndef THIN
layout(location = 2) out vec4 gbuffer_base;
layout(location = 3) out vec4 gbuffer_f0;
layout(location = 4) out vec4 gbuffer_emissive;
#endif

void main() {
    MaterialPoint point = material_at();
    gbuffer_normal = encode_lit_point(point.normal, point.roughness, point.occlusion, point.model);
    gbuffer_surface = encode_surface_point(SurfacePoint(v_surface, v_curvature, mesh_normal()));
#ifndef THIN
    gbuffer_base = vec4(point.standard.base_color, point.standard.metallic);
    gbuffer_f0 = vec4(point.standard.f0, point.standard.f90);
    gbuffer_emissive = vec4(point.emissive, 0.0);
#endif
}
