#include "physics/non_negative.h"

#include <algorithm>

namespace tyndall::physics {

void NonNegativeEquations::add(std::span<const double> basis, double wanted, double scale) {
    const size_t n = right_.size();
    for (size_t k = 0; k < n; ++k) {
        const double scaled = basis[k] * scale;
        right_[k] += scaled * wanted * scale;
        for (size_t j = 0; j < n; ++j) left_[k * n + j] += scaled * (basis[j] * scale);
    }
    wanted_ += wanted * scale * (wanted * scale);
}

std::vector<double> NonNegativeEquations::solve(int sweeps) const {
    const size_t n = right_.size();
    std::vector<double> w(n, 0.0);
    for (int sweep = 0; sweep < sweeps; ++sweep)
        for (size_t k = 0; k < n; ++k) {
            double slope = right_[k];
            for (size_t j = 0; j < n; ++j) slope -= left_[k * n + j] * w[j];
            w[k] = std::max(0.0, w[k] + slope / left_[k * n + k]);
        }
    return w;
}

double NonNegativeEquations::error(std::span<const double> weights) const {
    const size_t n = right_.size();
    double sum = wanted_;
    for (size_t k = 0; k < n; ++k) {
        sum -= 2.0 * weights[k] * right_[k];
        for (size_t j = 0; j < n; ++j) sum += weights[k] * weights[j] * left_[k * n + j];
    }
    return std::max(sum, 0.0);
}

}  // namespace tyndall::physics
