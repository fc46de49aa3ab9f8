#ifndef TYNDALL_PHYSICS_FRESNEL
#define TYNDALL_PHYSICS_FRESNEL
#include "physics/constants.glsl"
/// Reflection and refraction at smooth boundaries. Cosines are against the normal on the side the light comes from.

/// (1 - cosine)^5, the weight of F90 in Schlick's approximation.
FN float schlick_weight(float cosine) {
    float m = clamp(1.0f - cosine, 0.0f, 1.0f);
    float m2 = m * m;
    return m2 * m2 * m;
}

/// Schlick 1994: f0 at normal incidence, f90 at grazing.
FN vec3 fresnel_schlick(vec3 f0, vec3 f90, float cosine) { return f0 + (f90 - f0) * schlick_weight(cosine); }

/// Reflectance of a dielectric at normal incidence; `eta` = n_beyond / n_here, the same for its inverse.
FN float f0_from_eta(float eta) { return square((eta - 1.0f) / (eta + 1.0f)); }

/// Fresnel's equations for unpolarised light on a dielectric; `eta` = n_beyond / n_here; 1 under total reflection.
FN float fresnel_dielectric(float cosine, float eta) {
    float c = clamp(cosine, 0.0f, 1.0f);
    float g2 = eta * eta - 1.0f + c * c;
    if (g2 <= 0.0f) return 1.0f;
    float g = sqrt(g2);  // eta times the cosine beyond
    float perpendicular = (c - g) / (c + g);
    float parallel = (eta * eta * c - g) / (eta * eta * c + g);
    return 0.5f * (perpendicular * perpendicular + parallel * parallel);
}

/// Fresnel's equations for unpolarised light on a metal of complex index `eta` + i `k`, relative to the outside.
FN vec3 fresnel_conductor(float cosine, vec3 eta, vec3 k) {
    float c2 = clamp(cosine * cosine, 0.0f, 1.0f);
    float s2 = 1.0f - c2;
    vec3 t0 = eta * eta - k * k - s2;
    vec3 ab2 = sqrt(t0 * t0 + 4.0f * eta * eta * k * k);
    vec3 a = sqrt(max(0.5f * (ab2 + t0), vec3(0.0f)));
    vec3 p = ab2 + c2;
    vec3 q = 2.0f * cosine * a;
    vec3 perpendicular = (p - q) / (p + q);
    vec3 r = c2 * ab2 + s2 * s2;
    vec3 parallel = perpendicular * (r - q * s2) / (r + q * s2);
    return 0.5f * (perpendicular + parallel);
}

/// Diffuse Fresnel reflectance Fdr: the cosine-weighted mean reflectance met by diffuse light in a medium of index
/// `eta` relative to the other side (Egan & Hilgeman 1979): internal reflection for eta > 1, external below.
/// Absolute error against the integral below 0.002 for eta in 0.66..2.
FN float fresnel_diffuse_reflectance(float eta) {
    if (eta > 1.0f) return -1.440f / (eta * eta) + 0.710f / eta + 0.668f + 0.0636f * eta;
    float inverse = 1.0f / eta;
    return -0.4399f + inverse * (0.7099f + inverse * (-0.3319f + inverse * 0.0636f));
}

/// Snell: bends the unit vector `direction`, which travels against the unit `normal`; `eta` = n_here / n_beyond.
/// Returns false, and a zero vector, under total reflection.
FN bool refract_ray(vec3 direction, vec3 normal, float eta, OUT(vec3) transmitted) {
    float w = -eta * dot(direction, normal);
    float k2 = 1.0f + (w - eta) * (w + eta);
    if (k2 < 0.0f) {
        transmitted = vec3(0.0f);
        return false;
    }
    transmitted = normalize((w - sqrt(k2)) * normal + eta * direction);
    return true;
}

/// What radiance is multiplied by when it crosses into the other medium: (1 - F) n_beyond^2 / n_here^2, with
/// `eta` = n_beyond / n_here.
FN float transmitted_radiance_scale(float cosine, float eta) {
    return (1.0f - fresnel_dielectric(cosine, eta)) * eta * eta;
}

#endif
