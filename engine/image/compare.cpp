#include "image/compare.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/error.h"
#include "image/blocks.h"

namespace tyndall {
namespace {

constexpr double kLuminance[3] = {0.2126, 0.7152, 0.0722};  // Rec.709

size_t count_not_finite(const Image& image) {
    return static_cast<size_t>(std::ranges::count_if(image.floats(), [](float v) { return !std::isfinite(v); }));
}

Image fitted(const Image& image, const Image& reference) {
    if (image.channels < 3 || reference.channels < 3) throw Error("pictures of fewer than 3 channels are not compared");
    const int factor = image.width / std::max(reference.width, 1);
    if (factor < 1 || image.width != factor * reference.width || image.height != factor * reference.height)
        throw Error(Diagnostic{{},
                               fmt::format("pictures of {}x{} and {}x{} pixels do not fit", image.width, image.height,
                                           reference.width, reference.height),
                               "the reference's size or a whole multiple of it",
                               {}});
    return to_float(with_channels(box_downsample(image, factor), 3));
}

double encode_srgb(double x) {
    x = std::clamp(x, 0.0, 1.0);
    return x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1 / 2.4) - 0.055;
}

/// The p-th part of the sorted luminances, interpolated between neighbours.
double luminance_percentile(std::span<const float> rgb, double p) {
    std::vector<double> y(rgb.size() / 3);
    for (size_t i = 0; i < y.size(); ++i)
        for (size_t c = 0; c < 3; ++c) y[i] += kLuminance[c] * static_cast<double>(rgb[3 * i + c]);
    std::ranges::sort(y);
    const double at = p * static_cast<double>(y.size() - 1);
    const auto below = static_cast<size_t>(at);
    const size_t above = std::min(below + 1, y.size() - 1);
    return y[below] + (at - std::floor(at)) * (y[above] - y[below]);
}

double psnr(std::span<const float> reference, std::span<const float> test) {
    const double white = std::max(luminance_percentile(reference, 0.995), 1e-12);
    double sum = 0;
    for (size_t i = 0; i < reference.size(); ++i) {
        const double d =
            encode_srgb(static_cast<double>(reference[i]) / white) - encode_srgb(static_cast<double>(test[i]) / white);
        sum += d * d;
    }
    return 10 * std::log10(1 / std::max(sum / static_cast<double>(reference.size()), 1e-12));
}

struct Means {
    double channel[3] = {};
    [[nodiscard]] double all() const { return (channel[0] + channel[1] + channel[2]) / 3; }
};

Means means_of(std::span<const float> rgb) {
    Means means;
    for (size_t i = 0; i < rgb.size(); ++i) means.channel[i % 3] += static_cast<double>(rgb[i]);
    for (double& mean : means.channel) mean /= static_cast<double>(rgb.size() / 3);
    return means;
}

double ratio(double test, double reference) {
    return test == reference ? 1.0 : test / std::max(reference, 1e-12);
}

}  // namespace

LinearDifference compare_linear(const Image& reference, const Image& test, double tolerance) {
    const Image r_image = fitted(reference, reference);
    const Image t_image = fitted(test, reference);
    if (count_not_finite(r_image) > 0) throw Error("the reference picture holds NaN or Inf");
    LinearDifference result;
    result.not_finite = count_not_finite(t_image);
    if (result.not_finite > 0) {
        result.relative_mse = result.worst_block = result.max_difference = std::numeric_limits<double>::infinity();
        result.failing_fraction = 1;
        return result;
    }

    const auto r = r_image.floats();
    const auto t = t_image.floats();
    const Means r_mean = means_of(r);
    const Means t_mean = means_of(t);
    const double floor = std::max(std::pow(0.1 * r_mean.all(), 2), 1e-24);
    std::vector<float> errors(r.size() / 3);
    double sum = 0;
    size_t failing = 0;
    for (size_t i = 0; i < errors.size(); ++i) {
        double pixel = 0;
        for (size_t c = 3 * i; c < 3 * i + 3; ++c) {
            const double d = static_cast<double>(t[c]) - static_cast<double>(r[c]);
            pixel += d * d / (static_cast<double>(r[c]) * static_cast<double>(r[c]) + floor) / 3;
            result.max_difference = std::max(result.max_difference, std::abs(d));
        }
        errors[i] = static_cast<float>(pixel);
        sum += pixel;
        if (std::sqrt(pixel) > tolerance) ++failing;
    }
    result.relative_mse = sum / static_cast<double>(errors.size());
    result.failing_fraction = static_cast<double>(failing) / static_cast<double>(errors.size());
    result.mean_ratio = ratio(t_mean.all(), r_mean.all());
    for (size_t c = 0; c < 3; ++c) result.channel_mean_ratio[c] = ratio(t_mean.channel[c], r_mean.channel[c]);
    const Block worst = worst_block(errors, reference.width, reference.height);
    result.worst_block = worst.mean;
    result.worst_block_x = worst.x;
    result.worst_block_y = worst.y;
    result.psnr_db = psnr(r, t);
    return result;
}

}  // namespace tyndall
