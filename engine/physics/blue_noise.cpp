#include "physics/blue_noise.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace tyndall::physics {
namespace {

constexpr int kSize = kBlueNoiseSize;
constexpr int kCount = kSize * kSize;
constexpr float kSigma = 1.5f;  // texels; Ulichney's choice

/// Points on a torus, and how crowded each texel is: a Gaussian around every point.
class Pattern {
 public:
    Pattern() : kernel_(kCount), energy_(kCount, 0.0f), set_(kCount, false) {
        for (int i = 0; i < kCount; ++i) {
            const int x = std::min(i % kSize, kSize - i % kSize), y = std::min(i / kSize, kSize - i / kSize);
            kernel_[at(i)] = std::exp(-static_cast<float>(x * x + y * y) / (2.0f * kSigma * kSigma));
        }
    }

    void toggle(int point) {
        const float sign = set_[at(point)] ? -1.0f : 1.0f;
        set_[at(point)] = !set_[at(point)];
        const int px = point % kSize, py = point / kSize;
        for (int y = 0; y < kSize; ++y)
            for (int x = 0; x < kSize; ++x)
                energy_[at(y * kSize + x)] +=
                    sign * kernel_[at(((y - py) & (kSize - 1)) * kSize + ((x - px) & (kSize - 1)))];
    }

    [[nodiscard]] bool contains(int point) const { return set_[at(point)]; }
    /// The most crowded point, or the emptiest place.
    [[nodiscard]] int tightest_cluster() const { return extreme(true, 1.0f); }
    [[nodiscard]] int largest_void() const { return extreme(false, -1.0f); }

 private:
    [[nodiscard]] static size_t at(int i) { return static_cast<size_t>(i); }
    [[nodiscard]] int extreme(bool among, float sign) const {
        int best = -1;
        for (int i = 0; i < kCount; ++i)
            if (set_[at(i)] == among && (best < 0 || sign * energy_[at(i)] > sign * energy_[at(best)])) best = i;
        return best;
    }
    std::vector<float> kernel_, energy_;
    std::vector<bool> set_;
};

/// A tenth of the texels, spread until no move spreads them further.
Pattern initial_pattern() {
    Pattern pattern;
    uint32_t state = 1;
    for (int placed = 0; placed < kCount / 10;) {
        state = state * 747796405u + 2891336453u;
        const int point = static_cast<int>((state >> 16) % kCount);
        if (pattern.contains(point)) continue;
        pattern.toggle(point);
        ++placed;
    }
    for (;;) {
        const int cluster = pattern.tightest_cluster();
        pattern.toggle(cluster);
        const int hole = pattern.largest_void();
        pattern.toggle(hole);
        if (hole == cluster) return pattern;
    }
}

}  // namespace

std::vector<float> blue_noise_mask() {
    std::vector<float> mask(kCount);
    const auto rank = [&](int point, int value) {
        mask[static_cast<size_t>(point)] = (static_cast<float>(value) + 0.5f) / kCount;
    };
    const Pattern start = initial_pattern();
    Pattern shrinking = start;
    for (int value = kCount / 10 - 1; value >= 0; --value) {
        const int point = shrinking.tightest_cluster();
        rank(point, value);
        shrinking.toggle(point);
    }
    Pattern growing = start;
    for (int value = kCount / 10; value < kCount; ++value) {
        const int point = growing.largest_void();
        rank(point, value);
        growing.toggle(point);
    }
    return mask;
}

}  // namespace tyndall::physics
