// How surface points are kept between the geometry passes and the passes that light them.
//
// gbuffer_normal  rgba16  octahedral normal, roughness, shading model (4 bits) and occlusion (12 bits)
// gbuffer_surface rgba16  number of the surface in the scene (1 to 65535, 0 = nothing or beyond), curvature, octahedral
//                         normal of the mesh, without the normal map
// gbuffer_base    rgba16  base colour, metallic
// gbuffer_f0      rgba16  dielectric reflectance at normal incidence, at grazing incidence
// scene_depth     depth32f, reversed-Z: near / distance along the view, 0 where there is nothing
#include "physics/standard_surface.glsl"

// What the light passes read.
struct LitPoint {
    vec3 normal;
    float roughness;
    float occlusion;
    uint model;
};

// Unit vector to the octahedron unfolded onto [0, 1]^2 (Cigolle et al. 2014).
vec2 encode_octahedral(vec3 n) {
    vec2 p = n.xy / (abs(n.x) + abs(n.y) + abs(n.z));
    vec2 folded = (1.0 - abs(p.yx)) * vec2(p.x >= 0.0 ? 1.0 : -1.0, p.y >= 0.0 ? 1.0 : -1.0);
    return (n.z >= 0.0 ? p : folded) * 0.5 + 0.5;
}

vec3 decode_octahedral(vec2 encoded) {
    vec2 p = encoded * 2.0 - 1.0;
    float z = 1.0 - abs(p.x) - abs(p.y);
    float fold = max(-z, 0.0);
    return normalize(vec3(p.x + (p.x >= 0.0 ? -fold : fold), p.y + (p.y >= 0.0 ? -fold : fold), z));
}

// Occlusion keeps clear of both ends of its 12 bits: targets may round to the neighbouring value, which must not be
// another shading model's.
const float OCCLUSION_LOW = 48.0;
const float OCCLUSION_STEPS = 4000.0;

vec4 encode_lit_point(vec3 normal, float roughness, float occlusion, uint model) {
    float flags = float(model * 4096u) + OCCLUSION_LOW + round(clamp(occlusion, 0.0, 1.0) * OCCLUSION_STEPS);
    return vec4(encode_octahedral(normal), roughness, flags / 65535.0);
}

LitPoint decode_lit_point(vec4 texel) {
    uint flags = uint(texel.w * 65535.0 + 0.5);
    LitPoint point;
    point.normal = decode_octahedral(texel.xy);
    point.roughness = texel.z;
    point.occlusion = clamp((float(flags & 4095u) - OCCLUSION_LOW) / OCCLUSION_STEPS, 0.0, 1.0);
    point.model = flags >> 12;
    return point;
}

// The surface that is seen, without its material.
struct SurfacePoint {
    float number;     // of the surface, from 1 on; 0 = none
    float curvature;  // 1/m, of the mesh where it brings it
    vec3 normal;      // of the mesh, on the side that is seen
};

// Half of the curvature's values are below this, 1/m.
const float CURVATURE_MIDDLE = 100.0;

vec4 encode_surface_point(SurfacePoint point) {
    float number = point.number > 65535.5 ? 0.0 : point.number;
    float curvature = max(point.curvature, 0.0);
    return vec4(number / 65535.0, curvature / (curvature + CURVATURE_MIDDLE), encode_octahedral(point.normal));
}

float surface_number(vec4 texel) { return round(texel.x * 65535.0); }

SurfacePoint decode_surface_point(vec4 texel) {
    return SurfacePoint(surface_number(texel), CURVATURE_MIDDLE * texel.y / max(1.0 - texel.y, 1e-5),
                        decode_octahedral(texel.zw));
}

StandardMaterial decode_material(vec4 base, vec4 f0) { return StandardMaterial(base.rgb, base.a, f0.rgb, f0.a); }
