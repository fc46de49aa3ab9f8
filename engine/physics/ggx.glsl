#ifndef TYNDALL_PHYSICS_GGX
#define TYNDALL_PHYSICS_GGX
#include "physics/constants.glsl"
/// Trowbridge-Reitz (GGX) microfacets: isotropic, height-correlated Smith shadowing. n, v, l, h are unit vectors.

/// Width of the lobe for a perceptual roughness in 0..1: its square, never below that of roughness 0.045, which a
/// point light still shows without overflow.
FN float ggx_alpha(float roughness) { return square(clamp(roughness, 0.045f, 1.0f)); }

/// Density of the normals, 1/sr. The sine comes from the cross product: 1 - cos^2 would lose the peak of smooth
/// surfaces in 32 bits.
FN float ggx_distribution(vec3 n, vec3 h, float alpha) {
    vec3 s = cross(n, h);
    float a2 = alpha * alpha;
    return a2 * kInversePi / square(a2 * square(dot(n, h)) + dot(s, s));
}

/// Smith's Lambda for a direction at this cosine to the normal, cosine > 0.
FN float ggx_lambda(float cosine, float alpha) {
    float tan2 = max(0.0f, 1.0f - cosine * cosine) / (cosine * cosine);
    return 0.5f * (sqrt(1.0f + alpha * alpha * tan2) - 1.0f);
}

/// Height-correlated masking and shadowing divided by 4 NoL NoV (Heitz 2014), so that the BRDF is D V F.
FN float ggx_visibility(float nol, float nov, float alpha) {
    float a2 = alpha * alpha;
    float from_view = nol * sqrt(nov * nov * (1.0f - a2) + a2);
    float from_light = nov * sqrt(nol * nol * (1.0f - a2) + a2);
    return 0.5f / (from_view + from_light);
}

/// A microfacet normal as `v` sees them (Heitz 2018), in the frame where the surface's normal is z and v.z > 0.
/// The reflected direction has the density `ggx_reflection_pdf`.
FN vec3 sample_ggx_visible_normal(vec2 xi, vec3 v, float alpha) {
    vec3 stretched = normalize(vec3(alpha * v.x, alpha * v.y, v.z));
    float length2 = stretched.x * stretched.x + stretched.y * stretched.y;
    vec3 t1 = length2 > 0.0f ? vec3(-stretched.y, stretched.x, 0.0f) * inversesqrt(length2) : vec3(1.0f, 0.0f, 0.0f);
    vec3 t2 = cross(stretched, t1);
    float r = sqrt(xi.x);
    float phi = kTwoPi * xi.y;
    float x = r * cos(phi);
    float s = 0.5f * (1.0f + stretched.z);
    float y = (1.0f - s) * sqrt(max(0.0f, 1.0f - x * x)) + s * r * sin(phi);
    vec3 h = x * t1 + y * t2 + sqrt(max(0.0f, 1.0f - x * x - y * y)) * stretched;
    return normalize(vec3(alpha * h.x, alpha * h.y, max(h.z, 1e-6f)));
}

/// Density per steradian of the directions that `sample_ggx_visible_normal` reflects `v` into: G1(v) D / (4 NoV).
FN float ggx_reflection_pdf(vec3 n, vec3 v, vec3 h, float alpha) {
    float nov = max(dot(n, v), 1e-4f);
    return ggx_distribution(n, h, alpha) / (4.0f * nov * (1.0f + ggx_lambda(nov, alpha)));
}

/// What a direction drawn that way weighs, without Fresnel: G2 / G1 = (1 + Lambda(v)) / (1 + Lambda(v) + Lambda(l)).
FN float ggx_sample_weight(float nol, float nov, float alpha) {
    if (nol <= 0.0f) return 0.0f;
    float view = 1.0f + ggx_lambda(nov, alpha);
    return view / (view + ggx_lambda(nol, alpha));
}

#endif
