#include "mie/mie_series.h"

#include <algorithm>
#include <cmath>

namespace tyndall::mie {
namespace {

using Complex = std::complex<double>;

/// Logarithmic derivatives D_n(z) of psi_n, n = 0..last, by the recurrence downwards, which forgets where it started.
std::vector<Complex> logarithmic_derivatives(Complex z, int last) {
    const double size = std::abs(z);
    // the start is forgotten beyond |z| only, over some |z|^(1/3): Bohren & Huffman's 16 orders are too few for large
    // balls
    const int start = std::max(last, static_cast<int>(size + 8.0 * std::cbrt(size))) + 16;
    std::vector<Complex> d(static_cast<size_t>(start) + 1);
    for (int n = start; n > 0; --n) {
        const Complex ratio = static_cast<double>(n) / z;
        d[static_cast<size_t>(n) - 1] = ratio - 1.0 / (d[static_cast<size_t>(n)] + ratio);
    }
    d.resize(static_cast<size_t>(last) + 1);
    return d;
}

}  // namespace

MieSeries::MieSeries(double x, Complex m) : x_(x) {
    const int last = static_cast<int>(x + 4.0 * std::cbrt(x) + 2.0);
    const std::vector<Complex> derivatives = logarithmic_derivatives(m * x, last);
    // Riccati-Bessel functions by the recurrence upwards: psi_-1 = cos, psi_0 = sin; xi = psi - i chi
    double psi_before = std::cos(x), psi = std::sin(x);
    double chi_before = -std::sin(x), chi = std::cos(x);
    for (int n = 1; n <= last; ++n) {
        const double factor = (2.0 * n - 1.0) / x;
        const double psi_n = factor * psi - psi_before, chi_n = factor * chi - chi_before;
        const Complex xi_n(psi_n, -chi_n), xi(psi, -chi);
        const Complex d = derivatives[static_cast<size_t>(n)];
        const Complex for_a = d / m + n / x, for_b = d * m + n / x;
        a_.push_back((for_a * psi_n - psi) / (for_a * xi_n - xi));
        b_.push_back((for_b * psi_n - psi) / (for_b * xi_n - xi));
        psi_before = psi, psi = psi_n;
        chi_before = chi, chi = chi_n;
    }
}

double MieSeries::extinction() const {
    double sum = 0.0;
    for (size_t i = 0; i < a_.size(); ++i) sum += (2.0 * static_cast<double>(i) + 3.0) * (a_[i] + b_[i]).real();
    return 2.0 / (x_ * x_) * sum;
}

double MieSeries::scattering() const {
    double sum = 0.0;
    for (size_t i = 0; i < a_.size(); ++i)
        sum += (2.0 * static_cast<double>(i) + 3.0) * (std::norm(a_[i]) + std::norm(b_[i]));
    return 2.0 / (x_ * x_) * sum;
}

double MieSeries::mean_cosine() const {
    double sum = 0.0;
    for (size_t i = 0; i < a_.size(); ++i) {
        const double n = static_cast<double>(i) + 1.0;
        if (i + 1 < a_.size())
            sum += n * (n + 2.0) / (n + 1.0) * (a_[i] * std::conj(a_[i + 1]) + b_[i] * std::conj(b_[i + 1])).real();
        sum += (2.0 * n + 1.0) / (n * (n + 1.0)) * (a_[i] * std::conj(b_[i])).real();
    }
    return 4.0 / (x_ * x_) * sum / scattering();
}

void MieSeries::add_intensity(std::span<const double> cosines, double weight, std::span<double> intensity) const {
    struct Angle {
        double pi_before = 0.0, pi = 1.0;
        Complex s1, s2;
    };
    std::vector<Angle> angles(cosines.size());
    for (size_t i = 0; i < a_.size(); ++i) {
        const double n = static_cast<double>(i) + 1.0;
        const double scale = (2.0 * n + 1.0) / (n * (n + 1.0));
        const Complex a = scale * a_[i], b = scale * b_[i];
        for (size_t k = 0; k < angles.size(); ++k) {
            Angle& at = angles[k];
            const double mu = cosines[k];
            const double tau = n * mu * at.pi - (n + 1.0) * at.pi_before;
            at.s1 += a * at.pi + b * tau;
            at.s2 += a * tau + b * at.pi;
            const double next = ((2.0 * n + 1.0) * mu * at.pi - (n + 1.0) * at.pi_before) / n;
            at.pi_before = at.pi;
            at.pi = next;
        }
    }
    for (size_t k = 0; k < angles.size(); ++k)
        intensity[k] += weight * 0.5 * (std::norm(angles[k].s1) + std::norm(angles[k].s2));
}

}  // namespace tyndall::mie
