#ifndef TYNDALL_PHYSICS_TRANSMITTANCE
#define TYNDALL_PHYSICS_TRANSMITTANCE
#include "physics/constants.glsl"
/// Light lost and gained along a straight line. Lengths in metres, coefficients in 1/m.

/// Beer-Lambert: the share of light left after `metres` in a medium of extinction `sigma_t`.
FN vec3 beer_lambert(vec3 sigma_t, float metres) { return exp(-sigma_t * metres); }

/// (1 - exp(-x)) / x for x >= 0, which is 1 at x = 0: the mean transmittance along a segment of optical depth x.
/// Relative error below 5e-7 in 32 bits from 0 to 100 and beyond: a series below 0.25, where 1 - exp(-x) would cancel.
FN float mean_transmittance(float x) {
    if (x > 0.25f) return (1.0f - exp(-x)) / x;
    return 1.0f - x * (0.5f - x * (0.16666667f - x * (0.041666667f - x * (0.0083333333f - x * 0.0013888889f))));
}

/// The same for each channel, without branches.
FN vec3 mean_transmittance(vec3 x) {
    vec3 series = vec3(1.0f) -
                  x * (0.5f - x * (0.16666667f - x * (0.041666667f - x * (0.0083333333f - x * 0.0013888889f))));
    return mix(series, (vec3(1.0f) - exp(-x)) / max(x, vec3(0.25f)), greaterThan(x, vec3(0.25f)));
}

/// Light gathered over a segment of length `ds` with constant source `S` (radiance per metre) and extinction:
/// (S - S exp(-sigma_t ds)) / sigma_t (Hillaire 2015), S ds where sigma_t vanishes.
FN vec3 segment_integral(vec3 source, vec3 sigma_t, float ds) {
    return source * ds * mean_transmittance(sigma_t * ds);
}

/// One step of a front-to-back march: adds what the segment sends to the eye, then dims what lies behind it.
FN void accumulate_segment(vec3 source, vec3 sigma_t, float ds, INOUT(vec3) radiance, INOUT(vec3) transmittance) {
    radiance += transmittance * segment_integral(source, sigma_t, ds);
    transmittance *= beer_lambert(sigma_t, ds);
}

/// A distance in [0, ds) with density proportional to exp(-sigma_t t); `pdf` in 1/m. Uniform where sigma_t vanishes.
FN float sample_exponential_distance(float xi, float sigma_t, float ds, OUT(float) pdf) {
    float mean = mean_transmittance(sigma_t * ds);
    // -log(1 - xi (1 - exp(-tau))) / sigma_t, with 1 - exp(-tau) = tau mean; a series where the logarithm cancels
    float y = xi * sigma_t * ds * mean;
    float t = y < 0.01f ? xi * ds * mean * (1.0f + y * (0.5f + y * (0.33333333f + y * 0.25f)))
                        : -log(max(1.0f - y, 1e-30f)) / sigma_t;
    t = min(t, ds);
    pdf = exp(-sigma_t * t) / (ds * mean);
    return t;
}

/// The extinction that lets `color` (0..1) through at this distance: -log(color) / metres (RTR4 14.2).
/// A channel of 0 is taken as 1e-6: fourteen optical depths, black for any display.
FN vec3 sigma_t_from_color(vec3 color, float metres) {
    return -log(clamp(color, vec3(1e-6f), vec3(1.0f))) / max(metres, 1e-6f);
}

/// Density of height fog at height `y`, metres: 1 at the base, falling by e every scale height. Far below the base it
/// ends at e^60, so that what is multiplied with it stays finite.
FN float height_density(float y, float base, float scale_height) { return exp(min((base - y) / scale_height, 60.0f)); }

/// Optical depth of height fog (Wenzel 2006): extinction `sigma_t` at height `base`, falling by e every `scale_height`
/// metres, along a segment of length `ds` from height `y_from` to height `y_to`, all in metres. Level segments,
/// steep ones and both directions are one formula; relative error below 1e-5 while the heights fit 32 bits.
FN float height_fog_optical_depth(float sigma_t, float base, float scale_height, float y_from, float y_to,
                                  float ds) {
    float lowest = min(y_from, y_to);
    float drop = abs(y_to - y_from) / scale_height;
    return sigma_t * ds * height_density(lowest, base, scale_height) * mean_transmittance(drop);
}

/// The error function (Abramowitz & Stegun 1964, 7.1.26), absolute error below 5e-7 in 32 bits.
FN float error_function(float x) {
    float a = abs(x);
    float t = 1.0f / (1.0f + 0.3275911f * a);
    float tail = t * (0.254829592f + t * (-0.284496736f + t * (1.421413741f + t * (-1.453152027f + t * 1.061405429f)))) *
                 exp(-a * a);
    return x < 0.0f ? tail - 1.0f : 1.0f - tail;
}

/// Integral of exp(-|p - center|^2 / (2 radius^2)) over the part [t0, t1] of the ray p = origin + t direction. The
/// direction need not be a unit vector: with one in a medium's own space and t in metres, the result is in metres.
FN float gaussian_line_integral(vec3 origin, vec3 direction, vec3 center, float radius, float t0, float t1) {
    float speed = max(length(direction), 1e-20f);
    vec3 offset = origin - center;
    float foot = dot(offset, direction) / speed;
    vec3 aside = offset - direction * (foot / speed);
    float scale = 0.70710678f / radius;
    float along = error_function((t1 * speed + foot) * scale) - error_function((t0 * speed + foot) * scale);
    return exp(-dot(aside, aside) * scale * scale) * 1.25331414f * radius / speed * along;
}

#endif
