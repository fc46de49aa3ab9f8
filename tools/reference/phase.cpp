#include "reference/phase.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tyndall::reference {
namespace {

double mean_of(const glm::vec3& v) {
    return (static_cast<double>(v.x) + static_cast<double>(v.y) + static_cast<double>(v.z)) / 3.0;
}

/// Integral of (a + (b - a) (x - x0) / (x1 - x0)) sin x over [x0, x], in closed form.
double ramp_integral(double a, double b, double x0, double x1, double x) {
    const double slope = (b - a) / (x1 - x0);
    const auto anti = [&](double t) { return -(a + slope * (t - x0)) * std::cos(t) + slope * std::sin(t); };
    return anti(x) - anti(x0);
}

}  // namespace

Phase::Phase(const PhaseFunction& function) : kind_(static_cast<int>(function.kind)), parameters_(function.parameters) {
    if (function.kind != PhaseKind::tabulated || !function.table || function.table->values.size() < 2) return;
    values_ = function.table->values;
    const double step = std::numbers::pi / static_cast<double>(values_.size() - 1);
    cdf_.assign(1, 0.0);
    for (size_t i = 0; i + 1 < values_.size(); ++i) {
        const double x0 = static_cast<double>(i) * step;
        const double part = ramp_integral(mean_of(values_[i]), mean_of(values_[i + 1]), x0, x0 + step, x0 + step);
        cdf_.push_back(cdf_.back() + std::max(part, 0.0));
    }
}

glm::vec3 Phase::tabulated(float u) const {
    const float at =
        std::acos(std::clamp(u, -1.0f, 1.0f)) / std::numbers::pi_v<float> * static_cast<float>(values_.size() - 1);
    const size_t low = std::min(static_cast<size_t>(at), values_.size() - 2);
    return glm::mix(values_[low], values_[low + 1], at - static_cast<float>(low));
}

float Phase::sample_table(float xi) const {
    const double wanted = static_cast<double>(xi) * cdf_.back();
    const auto above = std::upper_bound(cdf_.begin() + 1, cdf_.end() - 1, wanted);
    const auto i = static_cast<size_t>(above - cdf_.begin()) - 1;
    const double step = std::numbers::pi / static_cast<double>(values_.size() - 1);
    const double x0 = static_cast<double>(i) * step, a = mean_of(values_[i]), b = mean_of(values_[i + 1]);
    double low = x0, high = x0 + step;
    for (int k = 0; k < 40; ++k) {  // the integral rises everywhere: halving finds its place
        const double middle = 0.5 * (low + high);
        (cdf_[i] + ramp_integral(a, b, x0, x0 + step, middle) < wanted ? low : high) = middle;
    }
    return static_cast<float>(std::cos(0.5 * (low + high)));
}

}  // namespace tyndall::reference
