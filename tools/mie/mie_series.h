#pragma once
/// Light scattered by a ball, exactly (Mie 1908), as Bohren & Huffman, "Absorption and Scattering of Light by Small
/// Particles" (1983), 4.4 and appendix A.

#include <complex>
#include <span>
#include <vector>

namespace tyndall::mie {

/// The series of one ball of size parameter x = 2 pi radius / wavelength and refractive index m relative to what is
/// around it; Im(m) > 0 absorbs. x from 1e-3 to 1e5.
class MieSeries {
 public:
    MieSeries(double x, std::complex<double> m);

    /// Cross sections over the ball's geometric one.
    [[nodiscard]] double extinction() const;
    [[nodiscard]] double scattering() const;
    /// Mean cosine of the scattering angle.
    [[nodiscard]] double mean_cosine() const;
    /// Adds `weight` (|S1|^2 + |S2|^2) / 2 at each scattering angle's cosine: k^2 times the differential cross section
    /// of unpolarised light.
    void add_intensity(std::span<const double> cosines, double weight, std::span<double> intensity) const;

 private:
    double x_;
    std::vector<std::complex<double>> a_, b_;  ///< from n = 1
};

}  // namespace tyndall::mie
