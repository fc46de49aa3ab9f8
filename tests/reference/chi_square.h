#pragma once
/// Whether samples follow the density they say they have.

#include <glm/vec3.hpp>
#include <random>
#include <string>
#include <vector>

#include "core/function_ref.h"

namespace tyndall::reference {

/// A right sampler fails a test so often, were its seed not fixed.
inline constexpr double kSignificance = 1e-3;

/// Numbers in [0, 1), the same on every machine.
class Dice {
 public:
    explicit Dice(uint32_t seed) : engine_(seed) {}
    float operator()() { return static_cast<float>(engine_() >> 8) * 0x1p-24f; }

 private:
    std::mt19937 engine_;
};

/// Probability that a chi-square of so many degrees of freedom is larger (Wilson & Hilferty 1931).
[[nodiscard]] double chi_square_tail(double chi_square, double degrees);

/// Pearson's test: prints p and expects it above kSignificance. Bins that expect less than 10 count as one. `expected`
/// and `observed` are numbers of samples.
void expect_distribution(const std::string& what, const std::vector<double>& expected,
                         const std::vector<double>& observed);

/// Bins of directions, even in z within [low, 1] and in azimuth about +z.
struct DirectionBins {
    int rows = 24, columns = 24;
    float low = -1.0f;

    [[nodiscard]] size_t count() const { return static_cast<size_t>(rows) * static_cast<size_t>(columns); }
    /// count() for a direction below `low`.
    [[nodiscard]] size_t of(const glm::vec3& direction) const;
    /// A direction in a bin, at x, y in [0, 1] of it.
    [[nodiscard]] glm::vec3 direction(size_t bin, float x, float y) const;
    [[nodiscard]] double solid_angle() const;
    /// Integrals of a density over the bins, by so many midpoints squared.
    [[nodiscard]] std::vector<double> integrals(int points, FunctionRef<double(const glm::vec3&)> density) const;
};

}  // namespace tyndall::reference
