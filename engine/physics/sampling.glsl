#ifndef TYNDALL_PHYSICS_SAMPLING
#define TYNDALL_PHYSICS_SAMPLING
#include "physics/constants.glsl"
/// Directions and points from two numbers `xi` in [0, 1). Local frames have +z as the axis. Densities are per steradian.

/// Two unit vectors perpendicular to the unit vector `n` and to each other (Duff et al. 2017); no direction is singular.
FN void orthonormal_basis(vec3 n, OUT(vec3) tangent, OUT(vec3) bitangent) {
    float s = n.z < 0.0f ? -1.0f : 1.0f;
    float a = -1.0f / (s + n.z);
    float b = n.x * n.y * a;
    tangent = vec3(1.0f + s * n.x * n.x * a, s * b, -s * n.x);
    bitangent = vec3(b, s + n.y * n.y * a, -n.y);
}

/// `local` in the frame whose z is the unit vector `n`.
FN vec3 to_frame(vec3 local, vec3 n) {
    vec3 tangent;
    vec3 bitangent;
    orthonormal_basis(n, tangent, bitangent);
    return tangent * local.x + bitangent * local.y + n * local.z;
}

/// A unit vector with this z and azimuth (radians).
FN vec3 spherical_direction(float z, float azimuth) {
    float r = sqrt(max(0.0f, 1.0f - z * z));
    return vec3(r * cos(azimuth), r * sin(azimuth), z);
}

/// A direction at angle acos(cosine) from the unit vector `axis`: turns a phase function's sample into a direction.
FN vec3 direction_about(vec3 axis, float cosine, float xi) {
    return to_frame(spherical_direction(cosine, kTwoPi * xi), axis);
}

/// Uniform over the sphere; density 1/(4 pi).
FN vec3 sample_uniform_sphere(vec2 xi) { return spherical_direction(1.0f - 2.0f * xi.x, kTwoPi * xi.y); }

/// Uniform over the hemisphere z >= 0; density 1/(2 pi).
FN vec3 sample_uniform_hemisphere(vec2 xi) { return spherical_direction(xi.x, kTwoPi * xi.y); }

/// Uniform within the cone of half-angle acos(cos_half_angle) about z; density `uniform_cone_pdf`.
FN vec3 sample_uniform_cone(vec2 xi, float cos_half_angle) {
    return spherical_direction(1.0f - xi.x * (1.0f - cos_half_angle), kTwoPi * xi.y);
}
FN float uniform_cone_pdf(float cos_half_angle) { return 1.0f / (kTwoPi * (1.0f - cos_half_angle)); }

/// Uniform over the unit disc, keeping neighbours together (Shirley & Chiu 1997).
FN vec2 sample_concentric_disc(vec2 xi) {
    float x = 2.0f * xi.x - 1.0f;
    float y = 2.0f * xi.y - 1.0f;
    if (x == 0.0f && y == 0.0f) return vec2(0.0f, 0.0f);
    bool wide = abs(x) > abs(y);
    float r = wide ? x : y;
    float phi = wide ? 0.25f * kPi * (y / x) : 0.5f * kPi - 0.25f * kPi * (x / y);
    return vec2(r * cos(phi), r * sin(phi));
}

/// Cosine-weighted over the hemisphere z >= 0 (Malley): density z / pi.
FN vec3 sample_cosine_hemisphere(vec2 xi) {
    vec2 d = sample_concentric_disc(xi);
    return vec3(d.x, d.y, sqrt(max(0.0f, 1.0f - d.x * d.x - d.y * d.y)));
}

#endif
