#include "mie/mie_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/mat3x3.hpp>
#include <numbers>

#include "core/parallel.h"
#include "mie/mie_series.h"

namespace tyndall::mie {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kAirIndex = 1.000272;  ///< of visible light at 20 C
constexpr double kFirstNm = 390.0, kLastNm = 720.0;
constexpr int kFiner = 6;  ///< angles computed for each one of the table

/// CIE 1931 observer: the fit of Wyman et al. (JCGT 2013).
glm::dvec3 observer(double nm) {
    const auto lobe = [nm](double height, double middle, double below, double above) {
        const double t = (nm - middle) / (nm < middle ? below : above);
        return height * std::exp(-0.5 * t * t);
    };
    return {lobe(1.056, 599.8, 37.9, 31.0) + lobe(0.362, 442.0, 16.0, 26.7) + lobe(-0.065, 501.1, 20.4, 26.2),
            lobe(0.821, 568.8, 46.9, 40.5) + lobe(0.286, 530.9, 16.3, 31.1),
            lobe(1.217, 437.0, 11.8, 36.0) + lobe(0.681, 459.0, 26.0, 13.8)};
}

/// What white light of a wavelength adds to red, green and blue.
glm::dvec3 channel_weights(double nm) {
    const double metres = nm * 1e-9;
    const double planck = 1e-33 / (std::pow(metres, 5.0) * std::expm1(0.014387769 / (metres * 6500.0)));
    const glm::dmat3 rec709_from_xyz(3.2404542, -0.9692660, 0.0556434, -1.5371385, 1.8760108, -0.2040259, -0.4985314,
                                     0.0415560, 1.0572252);
    return rec709_from_xyz * observer(nm) * planck;
}

struct Size {
    double radius_um, count;
};

/// Radii and how many there are of each: Hansen & Travis' gamma distribution, r^((1 - 3 b) / b) exp(-r / (a b)).
std::vector<Size> size_distribution(const DropletCloud& cloud) {
    if (cloud.variance <= 0.0) return {{cloud.radius_um, 1.0}};
    const double a = cloud.radius_um, b = std::min(cloud.variance, 0.33);
    const double spread = std::sqrt(b);
    const double low = std::log(a) - 4.0 * spread - b, high = std::log(a) + 3.5 * spread;
    std::vector<Size> sizes;
    for (int i = 0; i < cloud.sizes; ++i) {
        const double r = std::exp(low + (high - low) * (i + 0.5) / cloud.sizes);
        sizes.push_back({r, std::pow(r / a, (1.0 - 3.0 * b) / b) * std::exp(-(r / a - 1.0) / b) * r});
    }
    return sizes;
}

/// One wavelength's share: intensity in 1/sr (integral 1), mean cosine and efficiency.
struct Spectral {
    std::vector<double> intensity;
    double mean_cosine = 0.0, efficiency = 0.0;
};

Spectral spectral(double nm, const std::vector<Size>& sizes, const std::vector<double>& cosines) {
    Spectral result{std::vector<double>(cosines.size())};
    const double wave_number = 2.0 * kPi / (nm * 1e-3);  // per um
    double scattered = 0.0, lost = 0.0, area = 0.0;
    for (const Size& size : sizes) {
        const MieSeries series(wave_number * size.radius_um, water_index(nm));
        const double disc = size.count * kPi * size.radius_um * size.radius_um;
        series.add_intensity(cosines, size.count / (wave_number * wave_number), result.intensity);
        scattered += disc * series.scattering();
        lost += disc * series.extinction();
        area += disc;
        result.mean_cosine += disc * series.scattering() * series.mean_cosine();
    }
    for (double& value : result.intensity) value /= scattered;
    result.mean_cosine /= scattered;
    result.efficiency = lost / area;
    return result;
}

/// Means around each angle of the table, by weights that fall to 0 at its neighbours; the solid angle counts.
std::vector<glm::dvec3> smoothed(const std::vector<glm::dvec3>& fine, size_t count) {
    std::vector<glm::dvec3> values;
    const double step = kPi / static_cast<double>(fine.size() - 1);
    for (size_t i = 0; i < count; ++i) {
        glm::dvec3 sum(0.0);
        double weights = 0.0;
        for (int k = 1 - kFiner; k < kFiner; ++k) {
            const int at = static_cast<int>(i) * kFiner + k;
            if (at < 0 || at >= static_cast<int>(fine.size())) continue;
            const double solid = std::max(std::sin(step * at), 0.25 * step);
            const double weight = (1.0 - std::abs(k) / static_cast<double>(kFiner)) * solid;
            sum += weight * fine[static_cast<size_t>(at)];
            weights += weight;
        }
        values.push_back(glm::max(sum / weights, glm::dvec3(0.0)));
    }
    return values;
}

/// Integrals over the sphere of f and f cos, f linear between evenly spaced angles.
glm::dvec3 sphere_integral(const std::vector<glm::dvec3>& values, bool times_cosine) {
    constexpr int kParts = 8;
    const double step = kPi / static_cast<double>((values.size() - 1) * kParts);
    glm::dvec3 sum(0.0);
    for (size_t i = 0; i < (values.size() - 1) * kParts; ++i) {
        const double angle = (static_cast<double>(i) + 0.5) * step;
        const double part = (static_cast<double>(i % kParts) + 0.5) / kParts;
        const glm::dvec3 value = glm::mix(values[i / kParts], values[i / kParts + 1], part);
        sum += value * std::sin(angle) * (times_cosine ? std::cos(angle) : 1.0);
    }
    return 2.0 * kPi * step * sum;
}

}  // namespace

std::complex<double> water_index(double wavelength_nm) {
    // Harvey et al. 1998, equation 7, at 20 C and 998.2 kg/m3
    const double density = 0.9982, temperature = 293.15 / 273.15;
    const double l2 = wavelength_nm * wavelength_nm / (589.0 * 589.0);
    const double right = 0.244257733 + 9.74634476e-3 * density - 3.73234996e-3 * temperature +
                         2.68678472e-4 * l2 * temperature + 1.58920570e-3 / l2 +
                         2.45934259e-3 / (l2 - 0.2292020 * 0.2292020) + 0.900704920 / (l2 - 5.432937 * 5.432937) -
                         1.66626219e-2 * density * density;
    const double lorentz = right * density;
    const double real = std::sqrt((1.0 + 2.0 * lorentz) / (1.0 - lorentz)) / kAirIndex;
    constexpr std::array<double, 7> kAbsorption = {0.00663, 0.00922, 0.0204, 0.0565, 0.2224, 0.340, 0.624};  // 1/m
    const double at = std::clamp((wavelength_nm - 400.0) / 50.0, 0.0, 5.999999);
    const auto low = static_cast<size_t>(at);
    const double absorption = std::lerp(kAbsorption[low], kAbsorption[low + 1], at - static_cast<double>(low));
    return {real, absorption * wavelength_nm * 1e-9 / (4.0 * kPi)};
}

DropletTable droplet_table(const DropletCloud& cloud) {
    DropletTable table;
    const auto count = static_cast<size_t>(std::lround(180.0 / cloud.step_deg)) + 1;
    std::vector<double> cosines((count - 1) * kFiner + 1);
    for (size_t i = 0; i < cosines.size(); ++i)
        cosines[i] = std::cos(kPi * static_cast<double>(i) / static_cast<double>(cosines.size() - 1));
    const std::vector<Size> sizes = size_distribution(cloud);
    const auto waves = static_cast<size_t>(cloud.wavelengths);
    const auto wavelength = [&](size_t i) {
        return kFirstNm + (kLastNm - kFirstNm) * (static_cast<double>(i) + 0.5) / static_cast<double>(waves);
    };
    std::vector<Spectral> spectra(waves);
    parallel_for(0, waves, 1, [&](size_t first, size_t last) {
        for (size_t i = first; i < last; ++i) spectra[i] = spectral(wavelength(i), sizes, cosines);
    });
    std::vector<glm::dvec3> fine(cosines.size(), glm::dvec3(0.0));
    glm::dvec3 weights(0.0);
    for (size_t i = 0; i < waves; ++i) {
        const glm::dvec3 weight = channel_weights(wavelength(i));
        for (size_t k = 0; k < fine.size(); ++k) fine[k] += weight * spectra[i].intensity[k];
        table.efficiency += weight * spectra[i].efficiency;
        weights += weight;
    }
    table.efficiency /= weights;
    table.values = smoothed(fine, count);
    const glm::dvec3 integral = sphere_integral(table.values, false);
    for (glm::dvec3& value : table.values) value /= integral;
    table.mean_cosine = sphere_integral(table.values, true);
    for (size_t i = 0; i < count; ++i)
        table.angles_deg.push_back(180.0 * static_cast<double>(i) / static_cast<double>(count - 1));
    return table;
}

std::string table_text(const DropletTable& table, const DropletCloud& cloud) {
    std::string text = fmt::format(
        "# Phase function of water droplets, computed by `tyndall mie --radius-um {} --variance {} --sizes {} "
        "--wavelengths {} "
        "--step-deg {}`\n"
        "# mean cosine {:.4f} {:.4f} {:.4f}; extinction efficiency {:.3f} {:.3f} {:.3f}\n"
        "# angle_deg red green blue (1/sr)\n",
        cloud.radius_um, cloud.variance, cloud.sizes, cloud.wavelengths, cloud.step_deg, table.mean_cosine.x,
        table.mean_cosine.y, table.mean_cosine.z, table.efficiency.x, table.efficiency.y, table.efficiency.z);
    for (size_t i = 0; i < table.values.size(); ++i)
        text += fmt::format("{:.6g} {:.5g} {:.5g} {:.5g}\n", table.angles_deg[i], table.values[i].x, table.values[i].y,
                            table.values[i].z);
    return text;
}

}  // namespace tyndall::mie
