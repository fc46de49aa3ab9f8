#ifndef TYNDALL_PHYSICS_STANDARD_SURFACE
#define TYNDALL_PHYSICS_STANDARD_SURFACE
#include "physics/fresnel.glsl"
#include "physics/ggx.glsl"
/// The standard material: metallic-roughness with a GGX layer over a Lambertian base, no energy lost or gained.
///
/// In two halves, because the light pre-pass renderer adds up lights before it knows the material: `standard_light`
/// needs the normal and the roughness only, `standard_compose` the rest. Schlick's F = F0 (1 - w) + F90 w is linear in
/// F0 and F90, so the specular light is kept as two sums; diffuse light as one. What several bounces between
/// microfacets return is F0 (1/E - 1) of the single bounce (Turquin 2019), E the lobe's directional albedo.
/// The base receives what the layer does not reflect toward the EYE: the weight depends on NoV alone (it could not be
/// applied after the sum otherwise), so light is conserved but the diffuse term is not reciprocal.

/// Light arrived at a surface point, summed over lights. Linear: terms of several lights add.
struct LightTerms {
    vec3 diffuse;     ///< irradiance: sum of E NoL (lux)
    vec3 specular_a;  ///< sum of E NoL D V (1 - w), to be multiplied by F0
    vec3 specular_b;  ///< sum of E NoL D V w, to be multiplied by F90; w = (1 - VoH)^5
};

/// What `standard_compose` needs of a material at a point.
struct StandardMaterial {
    vec3 base_color;  ///< albedo of the base, and reflectance of the metal at normal incidence
    float metallic;   ///< share of metal, 0..1
    vec3 f0;          ///< reflectance of the dielectric layer at normal incidence
    float f90;        ///< and at grazing
};

/// No light.
FN LightTerms no_light() {
    LightTerms terms;
    terms.diffuse = vec3(0.0f);
    terms.specular_a = vec3(0.0f);
    terms.specular_b = vec3(0.0f);
    return terms;
}

/// The cosine toward the eye as shading uses it: normal maps may turn it negative.
FN float standard_nov(vec3 n, vec3 v) { return clamp(dot(n, v), 1e-3f, 1.0f); }

/// One light: `l` points to it, `irradiance` is what it gives a plane that faces it (lux, shadows and gobos applied).
FN LightTerms standard_light(vec3 n, vec3 v, vec3 l, float roughness, vec3 irradiance) {
    float nol = dot(n, l);
    if (nol <= 0.0f) return no_light();
    vec3 sum = l + v;
    vec3 h = sum * inversesqrt(max(dot(sum, sum), 1e-12f));
    float alpha = ggx_alpha(roughness);
    float w = schlick_weight(dot(v, h));
    LightTerms terms;
    terms.diffuse = irradiance * nol;
    vec3 lobe = terms.diffuse * (ggx_distribution(n, h, alpha) * ggx_visibility(nol, standard_nov(n, v), alpha));
    terms.specular_a = lobe * (1.0f - w);
    terms.specular_b = lobe * w;
    return terms;
}

/// Light from all around: `irradiance` on the surface, and `radiance` averaged over the specular lobe (a prefiltered
/// probe looked up along the reflected direction). `table` as in `standard_compose`.
FN LightTerms standard_environment(vec3 irradiance, vec3 radiance, vec2 table) {
    LightTerms terms;
    terms.diffuse = irradiance;
    terms.specular_a = radiance * table.x;
    terms.specular_b = radiance * table.y;
    return terms;
}

/// A material of the glTF model with KHR_materials_ior and _specular: `specular` 0..1 and `specular_color` scale a
/// dielectric's reflectance; 1.5, 1 and white are plain glTF.
FN StandardMaterial standard_material(vec3 base_color, float metallic, float ior, float specular, vec3 specular_color) {
    StandardMaterial m;
    m.base_color = base_color;
    m.metallic = metallic;
    m.f0 = min(f0_from_eta(ior) * specular_color, vec3(1.0f)) * specular;
    m.f90 = specular;
    return m;
}

/// Where the table of the lobe's albedo is looked up, in texture coordinates for `size` texels a side: the cosine
/// along x, the roughness along y, first and last texel at their ends. The root spends texels on grazing angles.
FN vec2 standard_table_coordinate(float nov, float roughness, float size) {
    vec2 unit = vec2(sqrt(clamp(nov, 0.0f, 1.0f)), clamp(roughness, 0.0f, 1.0f));
    return (unit * (size - 1.0f) + 0.5f) / size;
}

/// What several bounces between microfacets add: the single bounce times 1 + F0 (1/E - 1), E = table.x + table.y.
FN vec3 standard_multiple_bounces(vec3 f0, vec2 table) {
    return vec3(1.0f) + f0 * (1.0f / max(table.x + table.y, 1e-3f) - 1.0f);
}

/// Directional albedo of a specular layer at the angle and roughness of `table`, all bounces.
FN vec3 standard_specular_albedo(vec3 f0, float f90, vec2 table) {
    return min((f0 * table.x + f90 * table.y) * standard_multiple_bounces(f0, table), vec3(1.0f));
}

/// Radiance toward the eye: a dielectric and a metal, mixed as glTF has it. `table` = directional albedo of the lobe
/// for (F0, F90) = (1, 0) and (0, 1), looked up at `standard_table_coordinate` in the texture of tables.h.
FN vec3 standard_compose(StandardMaterial m, vec2 table, LightTerms terms) {
    vec3 base = m.base_color * kInversePi * (vec3(1.0f) - standard_specular_albedo(m.f0, m.f90, table));
    vec3 layer = (m.f0 * terms.specular_a + m.f90 * terms.specular_b) * standard_multiple_bounces(m.f0, table);
    vec3 metal = (m.base_color * terms.specular_a + terms.specular_b) * standard_multiple_bounces(m.base_color, table);
    return mix(base * terms.diffuse + layer, metal, m.metallic);
}

#endif
