// The one place that evaluates a material at a point of a surface; both render paths use it.
#include "render/shaders/material_maps.glsl"
#include "physics/standard_surface.glsl"

in vec3 v_position;
in vec3 v_normal;
#ifdef NORMAL_MAP
in vec4 v_tangent;
#endif

// What a solver needs to know of a surface point.
struct MaterialPoint {
    StandardMaterial standard;
    float roughness;  // perceptual
    vec3 normal;      // world, unit, on the side that is seen
    float occlusion;  // 1 = open
    vec3 emissive;    // cd/m2
    uint model;       // number of the shading model
    vec3 through;     // share of the base that light from the far side leaves by, where diffuse light goes through
    vec3 painted;     // share of the base that is paint's, over an interior
};

// The interpolated normal on the side that faces the eye.
vec3 mesh_normal() {
    vec3 n = normalize(v_normal);
    return gl_FrontFacing ? n : -n;
}

// The shading normal on the side that faces the eye.
vec3 material_normal() {
    vec3 n = normalize(v_normal);
#ifdef NORMAL_MAP
    vec3 t = v_tangent.xyz - n * dot(n, v_tangent.xyz);
    t *= inversesqrt(max(dot(t, t), 1e-12));
    vec3 b = cross(n, t) * v_tangent.w;
    vec3 m = texture(normal_map, uv_of(2)).xyz * 2.0 - 1.0;
    m.xy *= material.emissive_normal_scale.w;
    n = normalize(t * m.x + b * m.y + n * max(m.z, 1e-3));
#endif
    return gl_FrontFacing ? n : -n;
}

// Discards what the alpha mask leaves out.
MaterialPoint material_at() {
    MaterialPoint point;
    vec4 factors = material.metallic_roughness_occlusion_cutoff;
    vec4 base = base_colour_at();
#ifdef ALPHA_MASK
    if (base.a < factors.w) discard;
#endif
    float metallic = factors.x;
    point.roughness = factors.y;
    float occlusion = 1.0;
#ifdef METALLIC_ROUGHNESS_MAP
    vec3 packed_map = texture(metallic_roughness_map, uv_of(1)).rgb;
    metallic *= packed_map.b;
    point.roughness *= packed_map.g;
#ifdef SHARED_OCCLUSION
    occlusion = packed_map.r;
#endif
#endif
#ifdef OCCLUSION_MAP
    occlusion = texture(occlusion_map, uv_of(3)).r;
#endif
    point.occlusion = 1.0 + factors.z * (occlusion - 1.0);
    point.normal = material_normal();
    point.emissive = material.emissive_normal_scale.rgb;
#ifdef EMISSIVE_MAP
    point.emissive *= texture(emissive_map, uv_of(4)).rgb;
#endif
    vec4 specular = material.specular_colour_weight;
#ifdef SPECULAR_MAP
    specular.w *= texture(specular_map, uv_of(5)).a;
#endif
#ifdef SPECULAR_COLOUR_MAP
    specular.rgb *= texture(specular_colour_map, uv_of(6)).rgb;
#endif
    point.through = vec3(0.0);
#ifdef DIFFUSE_TRANSMISSION
    // The base is what leaves of light from both sides, so that one light buffer times one colour can hold it.
    vec4 transmission = diffuse_transmission_at();
    transmission.a *= 1.0 - metallic;
    vec3 through = transmission.a * transmission.rgb;
    base.rgb = (1.0 - transmission.a) * base.rgb + through;
    point.through = through / max(base.rgb, vec3(1e-6));
#endif
    point.painted = vec3(0.0);
#ifdef PAINT
    vec4 paint = paint_at();
    base.rgb = mix(base.rgb, paint.rgb, paint.a);
    point.painted = paint.a * paint.rgb / max(base.rgb, vec3(1e-6));
#endif
    point.standard =
        standard_material(base.rgb, metallic, material.ior_model.x, specular.w, specular.rgb);
    point.model = uint(material.ior_model.y);
    return point;
}
