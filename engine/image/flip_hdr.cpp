// HDR-FLIP, written from the paper: P. Andersson, J. Nilsson, P. Shirley, T. Akenine-Moeller, "Visualizing Errors in
// Rendered High Dynamic Range Images", Eurographics (short papers) 2021.
#include <algorithm>
#include <array>
#include <cmath>

#include "core/error.h"
#include "image/flip.h"

namespace tyndall {
namespace {

/// The ACES curve fitted by K. Narkowicz, without its own exposure of 0.6: (a x^2 + b x) / (c x^2 + d x + e).
constexpr double kA = 0.36 * 2.51, kB = 0.6 * 0.03, kC = 0.36 * 2.43, kD = 0.6 * 0.59, kE = 0.14;
/// What a shortest or longest exposure maps the brightest, or the median, luminance to.
constexpr double kT = 0.85;
/// Exposures beyond so many stops of the shortest one show nothing but noise around black.
constexpr double kMostStops = 24;

double tone_mapped(double x) {
    x = std::max(x, 0.0);
    return std::min((kA * x * x + kB * x) / (kC * x * x + kD * x + kE), 1.0);
}

/// The x that the curve maps to kT.
double inverse_of_kT() {
    const double a = kA - kT * kC, b = kB - kT * kD, c = -kT * kE;
    return (-b + std::sqrt(b * b - 4 * a * c)) / (2 * a);
}

struct Exposures {
    double start = 0, stop = 0;  ///< log2
    int count = 2;
};

/// From the reference alone: the first maps its brightest luminance to kT, the last its median. Where most of a picture
/// is black, the median is that of the rest: the paper's would be an infinite exposure.
Exposures exposures_of(const Image& reference) {
    std::vector<double> y(reference.value_count() / 3);
    const auto rgb = reference.floats();
    for (size_t i = 0; i < y.size(); ++i)
        y[i] = 0.2126 * static_cast<double>(rgb[3 * i]) + 0.7152 * static_cast<double>(rgb[3 * i + 1]) +
               0.0722 * static_cast<double>(rgb[3 * i + 2]);
    const auto median = [&] {
        const auto middle = y.begin() + static_cast<std::ptrdiff_t>(y.size() / 2);
        std::nth_element(y.begin(), middle, y.end());
        return *middle;
    };
    double middle = median();
    if (middle <= 0) {
        std::erase_if(y, [](double v) { return v <= 0; });
        if (y.empty()) return {};
        middle = median();
    }
    Exposures result;
    result.start = std::log2(inverse_of_kT() / std::ranges::max(y));
    result.stop = std::min(std::log2(inverse_of_kT() / middle), result.start + kMostStops);
    result.count = std::max(2, static_cast<int>(std::ceil(result.stop - result.start)));
    return result;
}

Image shown(const Image& linear, double exposure) {
    Image out = linear;
    const double factor = std::exp2(exposure);
    for (float& v : out.floats()) v = static_cast<float>(tone_mapped(factor * static_cast<double>(v)));
    return out;
}

Image finite_rgb(const Image& image) {
    Image rgb = to_float(with_channels(image, 3));
    for (const float v : rgb.floats())
        if (!std::isfinite(v)) throw Error("a picture to compare holds NaN or Inf");
    return rgb;
}

}  // namespace

HdrFlipDifference compare_hdr_flip(const Image& reference, const Image& test, float pixels_per_degree,
                                   const Mask& mask) {
    flip::check(reference, test, pixels_per_degree);
    const Image r = finite_rgb(reference), t = finite_rgb(test);
    const Exposures exposures = exposures_of(r);
    Image largest(r.width, r.height, 1, Image::Type::f32);
    for (int i = 0; i < exposures.count; ++i) {
        const double exposure = exposures.start + i * (exposures.stop - exposures.start) / (exposures.count - 1);
        const Image map = flip::map_of(shown(r, exposure), shown(t, exposure), pixels_per_degree);
        std::ranges::transform(largest.floats(), map.floats(), largest.floats().begin(),
                               [](float a, float b) { return std::max(a, b); });
    }
    HdrFlipDifference result;
    static_cast<FlipDifference&>(result) = flip::pooled(std::move(largest), mask);
    result.start_exposure = exposures.start;
    result.stop_exposure = exposures.stop;
    result.exposures = exposures.count;
    return result;
}

}  // namespace tyndall
