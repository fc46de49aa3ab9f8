#pragma once
/// Least squares whose unknowns are never negative: sums of Gaussians fitted to profiles.

#include <cstddef>
#include <span>
#include <vector>

namespace tyndall::physics {

/// The normal equations of a sum of functions with weights that are not negative.
class NonNegativeEquations {
 public:
    explicit NonNegativeEquations(size_t unknowns) : left_(unknowns * unknowns, 0.0), right_(unknowns, 0.0) {}

    /// At a place: the functions' values there, what they should sum up to, and how much an error there counts.
    void add(std::span<const double> basis, double wanted, double scale);
    /// By descent along one coordinate after the other.
    [[nodiscard]] std::vector<double> solve(int sweeps = 6000) const;
    /// Sum of the squares of (error times its scale) with these weights.
    [[nodiscard]] double error(std::span<const double> weights) const;

 private:
    std::vector<double> left_;  ///< row after row
    std::vector<double> right_;
    double wanted_ = 0.0;
};

}  // namespace tyndall::physics
