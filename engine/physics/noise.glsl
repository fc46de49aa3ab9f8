#ifndef TYNDALL_PHYSICS_NOISE
#define TYNDALL_PHYSICS_NOISE
#include "physics/sequences.glsl"
/// Fractal gradient noise, for densities that look like clouds and smoke. Hashed, without tables: the same on every
/// machine, and without a seam anywhere. It repeats after 2^24 features, beyond the precision of its argument.

/// Variance of gradient_noise over space, measured (the tests hold it to 2 %).
const float kGradientNoiseVariance = 0.0730f;

/// Lattice coordinate `cell` (an integer as a float, of either sign) modulo 2^24.
FN uint noise_lattice(float cell) { return uint(cell - 16777216.0f * floor(cell * 5.9604644775390625e-8f)); }

/// Dot product of `offset` with one of twelve gradients, the middles of a cube's edges (Perlin 2002), chosen by `hash`.
FN float noise_ramp(uint hash, vec3 offset) {
    uint h = hash >> 28u;
    float u = h < 8u ? offset.x : offset.y;
    float v = h < 4u ? offset.y : (h == 12u || h == 14u ? offset.x : offset.z);
    return ((h & 1u) == 0u ? u : -u) + ((h & 2u) == 0u ? v : -v);
}

/// The ramps of the four corners of a cell's face of constant x, blended by `fade`; `y`, `z` hold the low and the high
/// corner's coordinates, already spread over the bits.
FN float noise_face(uint x, uvec2 y, uvec2 z, vec3 offset, vec3 fade) {
    float low = mix(noise_ramp(hash_pcg(x ^ y.x ^ z.x), offset),
                    noise_ramp(hash_pcg(x ^ y.y ^ z.x), offset - vec3(0.0f, 1.0f, 0.0f)), fade.y);
    float high = mix(noise_ramp(hash_pcg(x ^ y.x ^ z.y), offset - vec3(0.0f, 0.0f, 1.0f)),
                     noise_ramp(hash_pcg(x ^ y.y ^ z.y), offset - vec3(0.0f, 1.0f, 1.0f)), fade.y);
    return mix(low, high, fade.z);
}

/// Gradient noise (Perlin, Improving Noise, SIGGRAPH 2002) of a place in cells: mean 0, within about +-1.04, with
/// continuous second derivatives. Different seeds give independent noise.
FN float gradient_noise(vec3 p, uint seed) {
    vec3 cell = floor(p);
    vec3 offset = p - cell;
    vec3 fade = offset * offset * offset * (offset * (offset * 6.0f - 15.0f) + 10.0f);
    uint x = noise_lattice(cell.x);
    uint y = noise_lattice(cell.y);
    uint z = noise_lattice(cell.z);
    uvec2 ys = uvec2(y, (y + 1u) & 0xffffffu) * 0x85ebca6bu;
    uvec2 zs = uvec2(z, (z + 1u) & 0xffffffu) * 0xc2b2ae35u;
    uint low = (x * 0x9e3779b1u) ^ seed;
    uint high = (((x + 1u) & 0xffffffu) * 0x9e3779b1u) ^ seed;
    return mix(noise_face(low, ys, zs, offset, fade), noise_face(high, ys, zs, offset - vec3(1.0f, 0.0f, 0.0f), fade),
               fade.x);
}

/// Where octave `octave` of fractal_noise looks up its gradient noise, for a place `p` in features. Octaves are shifted
/// against each other: the lattice points, where every one is 0, must not coincide.
FN vec3 fractal_noise_place(vec3 p, int octave) {
    return p * float(1u << uint(octave)) + vec3(0.137f, 0.271f, 0.413f) * float(octave);
}

/// Fractal sum of gradient noise divided by its standard deviation. `p` in features, the size of the largest; each of
/// the `octaves` (1..16) is half as large and half as strong as the one before.
FN float fractal_noise(vec3 p, int octaves) {
    float sum = 0.0f;
    float variance = 0.0f;
    float strength = 1.0f;
    for (int octave = 0; octave < octaves; ++octave) {
        sum += strength * gradient_noise(fractal_noise_place(p, octave), hash_pcg(uint(octave)));
        variance += strength * strength;
        strength *= 0.5f;
    }
    return sum / sqrt(max(variance, 1.0f) * kGradientNoiseVariance);
}

/// Density from fractal_noise `noise`: its logistic approximation of the normal distribution's share below it, which
/// spreads the values evenly over [0, 1], of which the upper share `coverage` (0..1) is stretched over [0, 1] and the
/// rest is 0. Never decreases with `noise`.
FN float noise_to_density(float noise, float coverage) {
    float share = 1.0f / (1.0f + exp(-1.702f * noise));
    return clamp((share - 1.0f + coverage) / max(coverage, 1e-4f), 0.0f, 1.0f);
}

/// Fractal noise as a density in [0, 1], not 0 in about the share `coverage` of space, with mean coverage / 2. `p` in
/// features.
FN float noise_density(vec3 p, int octaves, float coverage) {
    return noise_to_density(fractal_noise(p, octaves), coverage);
}

/// How the octaves of a fractal noise look: NOISE_PERLIN waves, NOISE_WORLEY round puffs.
const int NOISE_PERLIN = 0;
const int NOISE_WORLEY = 1;

/// Of the distance to the nearest of points thrown at random, one into each unit cell: mean and standard deviation,
/// measured (the tests hold them to 2 %).
const float kCellDistanceMean = 0.5204f;
const float kCellDistanceDeviation = 0.1724f;

/// Distance from `p`, in cells, to the nearest feature point (Worley, "A Cellular Texture Basis Function", 1996); one
/// point in each cell. Never steeper than 1 per cell. Different seeds give independent noise.
FN float cell_distance(vec3 p, uint seed) {
    vec3 cell = floor(p);
    vec3 offset = p - cell;
    float nearest = 9.0f;
    for (int z = -1; z < 2; ++z) {
        uint hash_z = (noise_lattice(cell.z + float(z)) * 0xc2b2ae35u) ^ seed;
        for (int y = -1; y < 2; ++y) {
            uint hash_y = (noise_lattice(cell.y + float(y)) * 0x85ebca6bu) ^ hash_z;
            for (int x = -1; x < 2; ++x) {
                uint hash = hash_pcg((noise_lattice(cell.x + float(x)) * 0x9e3779b1u) ^ hash_y);
                vec3 point = vec3(float(hash & 1023u), float((hash >> 10u) & 1023u), float((hash >> 20u) & 1023u));
                vec3 away = vec3(float(x), float(y), float(z)) + (point + 0.5f) * 0.0009765625f - offset;
                nearest = min(nearest, dot(away, away));
            }
        }
    }
    return sqrt(nearest);
}

/// Noise of round puffs with gradient_noise's mean and variance: high near the points, low between them.
FN float cellular_noise(vec3 p, uint seed) {
    return (kCellDistanceMean - cell_distance(p, seed)) * (0.27018512f / kCellDistanceDeviation);
}

/// The slope of gradient_noise, per cell.
FN vec3 gradient_noise_slope(vec3 p, uint seed) {
    vec3 cell = floor(p);
    vec3 offset = p - cell;
    vec3 fade = offset * offset * offset * (offset * (offset * 6.0f - 15.0f) + 10.0f);
    vec3 fade_slope = 30.0f * offset * offset * (offset - 1.0f) * (offset - 1.0f);
    vec3 slope = vec3(0.0f);
    for (int corner = 0; corner < 8; ++corner) {
        vec3 at = vec3(float(corner & 1), float((corner >> 1) & 1), float(corner >> 2));
        uint hash = hash_pcg((noise_lattice(cell.x + at.x) * 0x9e3779b1u) ^ seed ^
                             (noise_lattice(cell.y + at.y) * 0x85ebca6bu) ^ (noise_lattice(cell.z + at.z) * 0xc2b2ae35u));
        vec3 gradient = vec3(noise_ramp(hash, vec3(1.0f, 0.0f, 0.0f)), noise_ramp(hash, vec3(0.0f, 1.0f, 0.0f)),
                             noise_ramp(hash, vec3(0.0f, 0.0f, 1.0f)));
        float ramp = dot(gradient, offset - at);
        vec3 w = mix(vec3(1.0f) - fade, fade, at);
        vec3 dw = mix(vec3(0.0f) - fade_slope, fade_slope, at);
        slope += gradient * (w.x * w.y * w.z) +
                 ramp * vec3(dw.x * w.y * w.z, w.x * dw.y * w.z, w.x * w.y * dw.z);
    }
    return slope;
}

/// One over the root mean square of the cross product in noise_swirl, measured (the tests hold it to 5 %).
const float kSwirlScale = 0.8276f;

/// A displacement without sources or sinks, root mean square 1 feature: the cross product of two noises' slopes (DeWolf,
/// "Divergence-Free Noise", 2005), which is a curl as in Bridson et al., "Curl-Noise", 2007. Noise that is looked up at
/// displaced places swirls as smoke does. `p` in features; the two noises drift apart as `churn` (features) grows.
FN vec3 noise_swirl(vec3 p, float churn) {
    vec3 q = p * 0.5f;
    vec3 a = gradient_noise_slope(q + vec3(0.31f, 0.5f * churn, 0.77f), 0x5bd1e995u);
    vec3 b = gradient_noise_slope(q + vec3(0.5f * churn, 0.59f, -0.5f * churn), 0x1b873593u);
    return kSwirlScale * cross(a, b);
}

/// How much of an octave is kept whose features are `size` wide when it is sampled every `spacing`: all up to half a
/// feature, nothing from a whole one on.
FN float octave_share(float spacing, float size) { return clamp(2.0f - 2.0f * spacing / size, 0.0f, 1.0f); }

/// Mean of noise_to_density(kept + r, coverage) over noise r of variance `lost`, which was filtered out: what lies
/// between samples counts with its mean, so that nothing flickers and the amount stays. For coverage 1 it is exact for
/// normally distributed noise but for the logistic's own error; below, the values are taken as evenly spread around
/// their mean (exact for lost 0 and 1).
FN float filtered_noise_to_density(float kept, float lost, float coverage) {
    float mean_share = 1.0f / (1.0f + exp(-1.702f * kept / sqrt(1.0f + lost)));
    float r = clamp(lost / (1.0f + lost), 0.0f, 0.5f);
    float variance = 4.0f * mean_share * (1.0f - mean_share) * asin(r) * 0.15915494f;
    float half_width = max(sqrt(3.0f * variance), 1e-4f);
    float empty = 1.0f - coverage;
    float over = clamp(mean_share + half_width - empty, 0.0f, 2.0f * half_width);
    float mean_over = mean_share - half_width > empty ? mean_share - empty : over * over / (4.0f * half_width);
    return clamp(mean_over / max(coverage, 1e-4f), 0.0f, 1.0f);
}

/// Density of fractal noise of this kind (NOISE_...), between 0 and 1, with mean coverage / 2, for samples `spacing`
/// features apart: octaves finer than that fade into their mean, and cost nothing. spacing 0 is the noise itself.
FN float filtered_noise_density(vec3 p, int kind, int octaves, float coverage, float spacing) {
    float sum = 0.0f;
    float variance = 0.0f;
    float kept = 0.0f;
    float strength = 1.0f;
    int perlin = 0;
    int worley = 0;
    for (int octave = 0; octave < octaves; ++octave) {
        float share = octave_share(spacing, strength);
        variance += strength * strength;
        kept += share * share * strength * strength;
        perlin += share > 0.0f && kind == NOISE_PERLIN ? 1 : 0;
        worley += share > 0.0f && kind == NOISE_WORLEY ? 1 : 0;
        strength *= 0.5f;
    }
    strength = 1.0f;
    for (int octave = 0; octave < perlin; ++octave) {
        sum += octave_share(spacing, strength) * strength *
               gradient_noise(fractal_noise_place(p, octave), hash_pcg(uint(octave)));
        strength *= 0.5f;
    }
    for (int octave = 0; octave < worley; ++octave) {
        sum += octave_share(spacing, strength) * strength *
               cellular_noise(fractal_noise_place(p, octave), hash_pcg(uint(octave)));
        strength *= 0.5f;
    }
    variance = max(variance, 1e-6f);
    return filtered_noise_to_density(sum / sqrt(variance * kGradientNoiseVariance), 1.0f - kept / variance, coverage);
}

#endif
