#pragma once
/// The tracer's random numbers: a function of pixel, batch, sample and dimension alone.

#include <cstdint>
#include <glm/vec2.hpp>

#include "physics/physics.h"

namespace tyndall::reference {

/// Numbers in [0, 1) of one sample. The first dimensions are pairs of Sobol's first two dimensions with hashed Owen
/// scrambling, each pair shuffled against all others (Burley, "Practical Hash-based Owen Scrambling", 2020): the
/// samples of a batch are stratified against each other, whole batches are independent. Later ones are plain hashes.
class Sampler {
 public:
    Sampler(glm::uvec2 pixel, uint32_t seed, uint64_t batch, uint32_t index) : reversed_index_(reverse(index)) {
        uint32_t hash = physics::hash_pcg(pixel.x + 0x9e3779b9u);
        hash = physics::hash_pcg(hash ^ pixel.y);
        hash = physics::hash_pcg(hash ^ seed);
        hash = physics::hash_pcg(hash ^ static_cast<uint32_t>(batch));
        seed_ = physics::hash_pcg(hash ^ static_cast<uint32_t>(batch >> 32));
        state_ = physics::hash_pcg(seed_ ^ (index * 0x85ebca6bu + 0x68bc21ebu));
    }

    [[nodiscard]] float next() {
        if (pair_ >= kSobolPairs) return physics::random_float(state_);
        return next2().x;
    }
    [[nodiscard]] glm::vec2 next2() {
        if (pair_ >= kSobolPairs) {
            const float x = physics::random_float(state_);
            return {x, physics::random_float(state_)};
        }
        const uint32_t seed = physics::hash_pcg(seed_ ^ (++pair_ * 0x9e3779b9u));
        const uint32_t index = reverse(laine_karras(reversed_index_, seed));  // shuffled against other pairs
        return {physics::unit_float(reverse(laine_karras(index, seed ^ 0xa511e9b3u))),
                physics::unit_float(reverse(laine_karras(pascal(index), seed ^ 0x63d83595u)))};
    }
    /// From here on numbers are plain hashes: for loops whose length differs from sample to sample.
    [[nodiscard]] float next_independent() { return physics::random_float(state_); }

 private:
    static constexpr uint32_t kSobolPairs = 32;

    static uint32_t reverse(uint32_t x) {
        x = __builtin_bswap32(x);
        x = ((x & 0x0f0f0f0fu) << 4) | ((x >> 4) & 0x0f0f0f0fu);
        x = ((x & 0x33333333u) << 2) | ((x >> 2) & 0x33333333u);
        return ((x & 0x55555555u) << 1) | ((x >> 1) & 0x55555555u);
    }
    /// The Laine-Karras hash with Vegdahl's constants: an Owen scrambling of reversed bits.
    static uint32_t laine_karras(uint32_t x, uint32_t seed) {
        x ^= x * 0x3d20adeau;
        x += seed;
        x *= (seed >> 16) | 1u;
        x ^= x * 0x05526c56u;
        x ^= x * 0x53a22864u;
        return x;
    }
    /// Sobol's second dimension with its bits reversed: Pascal's triangle modulo 2 as a matrix, by halves (Ahmed, "An
    /// Implementation Algorithm of 2D Sobol Sequence Fast, Elegant, and Compact", 2024). The first is the index itself.
    static uint32_t pascal(uint32_t x) {
        x ^= x >> 16;
        x ^= (x & 0xff00ff00u) >> 8;
        x ^= (x & 0xf0f0f0f0u) >> 4;
        x ^= (x & 0xccccccccu) >> 2;
        return x ^ ((x & 0xaaaaaaaau) >> 1);
    }

    uint32_t reversed_index_, seed_, state_;
    uint32_t pair_ = 0;
};

}  // namespace tyndall::reference
