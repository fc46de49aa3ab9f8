#ifndef TYNDALL_PHYSICS_SH
#define TYNDALL_PHYSICS_SH
#include "physics/constants.glsl"
/// Three bands of real spherical harmonics, for light that comes from all around.

/// Nine RGB coefficients, w unused: the layout is that of a std140 uniform block. Order: Y00, Y1(y, z, x),
/// Y2(xy, yz, 3z^2-1, xz, x^2-y^2), all with positive sign.
struct Sh9 {
    vec4 c[9];
};

/// The nine functions at the unit vector `d`.
FN void sh9_basis(vec3 d, OUT(float) y0, OUT(vec3) y1, OUT(vec4) y2, OUT(float) y2_last) {
    y0 = 0.282094792f;
    y1 = 0.488602512f * vec3(d.y, d.z, d.x);
    y2 = vec4(1.092548431f * d.x * d.y, 1.092548431f * d.y * d.z, 0.315391565f * (3.0f * d.z * d.z - 1.0f),
              1.092548431f * d.x * d.z);
    y2_last = 0.546274215f * (d.x * d.x - d.y * d.y);
}

/// Sum of the series, each band scaled.
FN vec3 sh9_sum(Sh9 sh, vec3 d, float band0, float band1, float band2) {
    float y0;
    vec3 y1;
    vec4 y2;
    float y2_last;
    sh9_basis(d, y0, y1, y2, y2_last);
    vec4 sum = band0 * y0 * sh.c[0] + band1 * (y1.x * sh.c[1] + y1.y * sh.c[2] + y1.z * sh.c[3]) +
               band2 * (y2.x * sh.c[4] + y2.y * sh.c[5] + y2.z * sh.c[6] + y2.w * sh.c[7] + y2_last * sh.c[8]);
    return vec3(sum.x, sum.y, sum.z);
}

/// The projected function itself at `d`; negative where the bands ring.
FN vec3 sh9_evaluate(Sh9 sh, vec3 d) { return sh9_sum(sh, d, 1.0f, 1.0f, 1.0f); }

/// Irradiance on a plane of unit normal `n` under the projected radiance (Ramamoorthi & Hanrahan 2001): mean error
/// about 1 % for natural light; never negative.
FN vec3 sh9_irradiance(Sh9 sh, vec3 n) {
    return max(sh9_sum(sh, n, kPi, 2.0f * kPi / 3.0f, 0.25f * kPi), vec3(0.0f));
}

/// Latitude-longitude images: the unit direction `d` to texture coordinates. +Y is the top row; the middle column
/// looks along -Z, +X is to its right.
FN vec2 direction_to_equirect(vec3 d) {
    float u = abs(d.x) + abs(d.z) > 0.0f ? atan(d.x, -d.z) / kTwoPi : 0.0f;
    return vec2(0.5f + u, acos(clamp(d.y, -1.0f, 1.0f)) * kInversePi);
}

/// And back.
FN vec3 equirect_to_direction(vec2 uv) {
    float azimuth = kTwoPi * (uv.x - 0.5f);
    float polar = kPi * uv.y;
    return vec3(sin(polar) * sin(azimuth), cos(polar), -sin(polar) * cos(azimuth));
}

#endif
