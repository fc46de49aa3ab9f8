#ifndef TYNDALL_PHYSICS_AIRLIGHT
#define TYNDALL_PHYSICS_AIRLIGHT
#include "physics/constants.glsl"
/// Light scattered into a view ray by a point light: where to sample it, and its closed form in plain fog.

/// A distance on the ray, in [t_min, t_max], with a density that follows 1/d^2 to a point light
/// (Kulla & Fajardo 2012). `direction` is a unit vector; `pdf` in 1/m. A ray through the light counts as passing
/// it at 1 mm.
FN float sample_equi_angular(float xi, float t_min, float t_max, vec3 origin, vec3 direction, vec3 light,
                             OUT(float) pdf) {
    float closest = dot(light - origin, direction);
    float passing = max(length(light - origin - closest * direction), 1e-3f);
    float from = atan((t_min - closest) / passing);
    float to = atan((t_max - closest) / passing);
    float offset = passing * tan(mix(from, to, xi));
    pdf = passing / ((to - from) * (passing * passing + offset * offset));
    return clamp(closest + offset, t_min, t_max);
}

/// exp(-u tan x) 2 w at x = end - width w^2, for both w `node` half widths from the middle of 0..1.
FN float airlight_pair(float u, float end, float width, float node) {
    float w0 = 0.5f - 0.5f * node;
    float w1 = 0.5f + 0.5f * node;
    return w0 * exp(-u * tan(end - width * w0 * w0)) + w1 * exp(-u * tan(end - width * w1 * w1));
}

/// Integral of exp(-u tan x) over v0..v1, u > 0, -pi/2 < v0 <= v1 < pi/2: Sun et al.'s F(u, v1) - F(u, v0) in one.
/// Sixteen-point Gauss-Legendre, crowded toward v1, where the integrand of thin fog drops, and ended where it has
/// fallen by e^-20, for thick fog.
FN float airlight_integral(float u, float v0, float v1) {
    float end = min(v1, atan(tan(v0) + 20.0f / u));
    float width = end - v0;
    float sum = 0.1894506105f * airlight_pair(u, end, width, 0.0950125098f);
    sum += 0.1826034150f * airlight_pair(u, end, width, 0.2816035508f);
    sum += 0.1691565194f * airlight_pair(u, end, width, 0.4580167777f);
    sum += 0.1495959888f * airlight_pair(u, end, width, 0.6178762444f);
    sum += 0.1246289713f * airlight_pair(u, end, width, 0.7554044084f);
    sum += 0.0951585117f * airlight_pair(u, end, width, 0.8656312024f);
    sum += 0.0622535239f * airlight_pair(u, end, width, 0.9445750231f);
    sum += 0.0271524594f * airlight_pair(u, end, width, 0.9894009350f);
    return width * sum;
}

/// Radiance that a point light of `intensity` (cd or W/sr) scatters into a view ray up to a surface: uniform isotropic
/// fog without absorption, extinction `beta` (1/m), no shadows (Sun et al. 2005). `to_light` = distance eye-light (m),
/// `cos_gamma` = cosine of the angle between the ray and the light, `to_surface` = length of the ray (m).
/// Singular when the ray looks at the light itself: gamma below 1e-3 counts as 1e-3. Relative error below 1e-4.
FN float airlight_point(float intensity, float beta, float to_light, float cos_gamma, float to_surface) {
    float sin_gamma = max(sqrt(max(0.0f, 1.0f - cos_gamma * cos_gamma)), 1e-3f);
    float gamma = atan(sin_gamma, cos_gamma);
    float depth_light = beta * to_light;
    float a1 = depth_light * sin_gamma;
    float a0 = beta * beta * intensity * exp(-depth_light * cos_gamma) / (kTwoPi * a1);
    float end = 0.25f * kPi + 0.5f * atan((beta * to_surface - depth_light * cos_gamma) / a1);
    return a0 * airlight_integral(a1, 0.5f * gamma, end);
}

/// The same into a ray without end, times sin gamma, D / (sigma_s I): what a surface's integral over directions around the
/// light needs (Sun et al. 2005, 5.2). `depth` = optical distance to the light, `gamma` = angle to it in 0..pi.
FN float airlight_around(float depth, float gamma) {
    float u = max(depth * sin(gamma), 1e-9f);
    return exp(-depth * cos(gamma)) * airlight_integral(u, 0.5f * gamma, 0.5f * kPi) / kTwoPi;
}

#endif
