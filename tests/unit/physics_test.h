#pragma once
/// What the physics tests share: quadrature in double, measured figures on the console, a test of sample densities.

#include <gtest/gtest.h>

#include <cstdio>
#include <functional>
#include <random>
#include <vector>

#include "physics/physics.h"

namespace tyndall::physics {

/// Prints a measured figure, so that a log of the tests is the record of the errors that the documentation states.
inline void measured(const char* what, double value) {
    std::printf("[ measured ] %s: %.3g\n", what, value);
}

/// Gauss-Legendre of four points on each of `cells` cells.
inline double integrate(const std::function<double(double)>& f, double from, double to, int cells) {
    static constexpr double kNode[2] = {0.3399810435848563, 0.8611363115940526};
    static constexpr double kWeight[2] = {0.6521451548625461, 0.3478548451374538};
    const double h = 0.5 * (to - from) / cells;
    double sum = 0.0;
    for (int i = 0; i < cells; ++i) {
        const double middle = from + (2 * i + 1) * h;
        for (int k = 0; k < 2; ++k) sum += kWeight[k] * (f(middle - h * kNode[k]) + f(middle + h * kNode[k]));
    }
    return sum * h;
}

/// Random numbers with a fixed seed, in [0, 1).
class Random {
 public:
    explicit Random(unsigned seed) : engine_(seed) {}
    float operator()() { return float(engine_() >> 8) * 0x1p-24f; }
    float between(float low, float high) { return low + (high - low) * (*this)(); }
    vec2 pair() {
        const float x = (*this)();
        return {x, (*this)()};
    }
    vec3 direction() {
        const float z = between(-1.0f, 1.0f);
        const float phi = between(0.0f, kTwoPi);
        const float r = std::sqrt(1.0f - z * z);
        return {r * std::cos(phi), r * std::sin(phi), z};
    }

 private:
    std::mt19937 engine_;
};

/// Pearson's statistic of `counts` against `expected` as a number of standard deviations above its mean; bins expecting
/// fewer than ten are pooled. A right sampler stays below 4, a wrong density of a few percent is far above.
inline double chi_square_excess(const std::vector<double>& counts, const std::vector<double>& expected) {
    double statistic = 0.0, pooled_count = 0.0, pooled_expected = 0.0;
    int bins = 0;
    for (size_t i = 0; i < counts.size(); ++i) {
        if (expected[i] < 10.0) {
            pooled_count += counts[i];
            pooled_expected += expected[i];
            continue;
        }
        statistic += (counts[i] - expected[i]) * (counts[i] - expected[i]) / expected[i];
        ++bins;
    }
    if (pooled_expected >= 1.0) {
        statistic += (pooled_count - pooled_expected) * (pooled_count - pooled_expected) / pooled_expected;
        ++bins;
    } else {
        statistic += pooled_count > 20.0 ? 1e9 : 0.0;  // samples where there should be none
    }
    return (statistic - (bins - 1)) / std::sqrt(2.0 * std::max(bins - 1, 1));
}

}  // namespace tyndall::physics
