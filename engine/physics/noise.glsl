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

#endif
