#ifndef TYNDALL_PHYSICS_SEQUENCES
#define TYNDALL_PHYSICS_SEQUENCES
/// Numbers in [0, 1): low-discrepancy sequences, dither and hashes. Every one is below 1, never equal to it.

/// The upper 24 bits of `bits` as a number in [0, 1): exact, so it never rounds up to 1.
FN float unit_float(uint bits) { return float(bits >> 8u) * 5.9604644775390625e-8f; }

/// Van der Corput's radical inverse of `index` in base 2.
FN float radical_inverse_2(uint index) { return unit_float(bitfieldReverse(index)); }

/// Point `index` of `count` of the Hammersley set.
FN vec2 hammersley(uint index, uint count) { return vec2(float(index) / float(count), radical_inverse_2(index)); }

/// Point `index` of the R2 sequence (Roberts 2018), which has no fixed length. In integers: no drift for large indices.
FN vec2 r2_sequence(uint index) {
    return vec2(unit_float(index * 3242174889u + 2147483648u), unit_float(index * 2447445414u + 2147483648u));
}

/// Point `index` of the golden-ratio sequence, its one-dimensional sister; shifts a dither from frame to frame.
FN float golden_ratio_sequence(uint index) { return unit_float(index * 2654435769u + 2147483648u); }

/// Interleaved gradient noise (Jimenez 2014) of a pixel: any 3x3 block holds nine spread values. `pixel` in pixels.
FN float interleaved_gradient_noise(vec2 pixel) {
    return fract(52.9829189f * fract(dot(pixel, vec2(0.06711056f, 0.00583715f))));
}

/// Hashes an integer (PCG-RXS-M-XS, Jarzynski & Olano 2020).
FN uint hash_pcg(uint value) {
    uint state = value * 747796405u + 2891336453u;
    uint word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
    return (word >> 22u) ^ word;
}

/// The next number of a small generator; `state` may start anywhere, hashed seeds are best.
FN float random_float(INOUT(uint) state) {
    state = state * 747796405u + 2891336453u;
    uint word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
    return unit_float((word >> 22u) ^ word);
}

#endif
