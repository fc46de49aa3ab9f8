#include "image/compare.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "core/error.h"
#include "image/blocks.h"

namespace tyndall {
namespace {

constexpr double kLuminance[3] = {0.2126, 0.7152, 0.0722};  // Rec.709

bool counts(const Mask& mask, size_t pixel) {
    return mask.empty() || mask[pixel] != 0;
}

/// NaN and Inf of the pixels that count, and the first of these.
struct Broken {
    size_t values = 0;
    size_t pixel = 0;

    Broken(std::span<const float> rgb, const Mask& mask) {
        for (size_t i = 0; i < rgb.size(); ++i)
            if (!std::isfinite(rgb[i]) && counts(mask, i / 3) && values++ == 0) pixel = i / 3;
    }
};

double encode_srgb(double x) {
    x = std::clamp(x, 0.0, 1.0);
    return x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1 / 2.4) - 0.055;
}

/// The p-th part of the sorted luminances, interpolated between neighbours.
double luminance_percentile(std::span<const float> rgb, double p) {
    std::vector<double> y(rgb.size() / 3);
    for (size_t i = 0; i < y.size(); ++i)
        for (size_t c = 0; c < 3; ++c) y[i] += kLuminance[c] * static_cast<double>(rgb[3 * i + c]);
    std::erase_if(y, [](double v) { return !std::isfinite(v); });  // of what a mask leaves out
    if (y.empty()) return 0;
    std::ranges::sort(y);
    const double at = p * static_cast<double>(y.size() - 1);
    const auto below = static_cast<size_t>(at);
    const size_t above = std::min(below + 1, y.size() - 1);
    return y[below] + (at - std::floor(at)) * (y[above] - y[below]);
}

double psnr(std::span<const float> reference, std::span<const float> test, double exposure, const Mask& mask) {
    double sum = 0;
    size_t count = 0;
    for (size_t i = 0; i < reference.size(); ++i) {
        if (!counts(mask, i / 3)) continue;
        const double d = encode_srgb(static_cast<double>(reference[i]) * exposure) -
                         encode_srgb(static_cast<double>(test[i]) * exposure);
        sum += d * d;
        ++count;
    }
    return 10 * std::log10(1 / std::max(sum / static_cast<double>(count), 1e-12));
}

struct Means {
    double channel[3] = {};
    [[nodiscard]] double all() const { return (channel[0] + channel[1] + channel[2]) / 3; }

    Means(std::span<const float> rgb, const Mask& mask) {
        size_t count = 0;
        for (size_t i = 0; i < rgb.size(); ++i)
            if (counts(mask, i / 3)) channel[i % 3] += static_cast<double>(rgb[i]), ++count;
        for (double& mean : channel) mean /= static_cast<double>(std::max<size_t>(count / 3, 1));
    }
};

double ratio(double test, double reference) {
    return test == reference ? 1.0 : test / std::max(reference, 1e-12);
}

/// The map of relative squared errors, and what it says as a whole.
void fill_errors(LinearDifference& result, std::span<const float> r, std::span<const float> t, double floor,
                 double tolerance, const Mask& mask) {
    const std::span<float> errors = result.map.floats();
    double sum = 0;
    size_t failing = 0, count = 0;
    for (size_t i = 0; i < errors.size(); ++i) {
        if (!counts(mask, i)) continue;
        double pixel = 0;
        for (size_t c = 3 * i; c < 3 * i + 3; ++c) {
            const double d = static_cast<double>(t[c]) - static_cast<double>(r[c]);
            pixel += d * d / (static_cast<double>(r[c]) * static_cast<double>(r[c]) + floor) / 3;
            result.max_difference = std::max(result.max_difference, std::abs(d));
        }
        errors[i] = static_cast<float>(pixel);
        sum += pixel;
        ++count;
        if (std::sqrt(pixel) > tolerance) ++failing;
    }
    result.relative_mse = sum / static_cast<double>(std::max<size_t>(count, 1));
    result.failing_fraction = static_cast<double>(failing) / static_cast<double>(std::max<size_t>(count, 1));
}

}  // namespace

Mask mask_of(const Image& image) {
    const Image values = to_float(image);
    const auto channels = static_cast<size_t>(image.channels);
    const size_t colours = channels == 2 ? 1 : std::min<size_t>(channels, 3);  // alpha does not count
    Mask mask(values.value_count() / std::max<size_t>(channels, 1));
    for (size_t i = 0; i < mask.size(); ++i)
        for (size_t c = 0; c < colours; ++c)
            if (values.floats()[i * channels + c] != 0) mask[i] = 1;
    if (std::ranges::none_of(mask, [](auto v) { return v != 0; })) throw Error("a mask leaves no pixel to compare");
    return mask;
}

Image fitted_to(const Image& image, const Image& reference) {
    if (image.channels < 3 || reference.channels < 3) throw Error("pictures of fewer than 3 channels are not compared");
    const int factor = image.width / std::max(reference.width, 1);
    if (factor < 1 || image.width != factor * reference.width || image.height != factor * reference.height)
        throw Error(Diagnostic{{},
                               fmt::format("a picture of {}x{} pixels is held against a reference of {}x{}",
                                           image.width, image.height, reference.width, reference.height),
                               "the reference's size or a whole multiple of it",
                               {}});
    return to_float(with_channels(box_downsample(image, factor), 3));
}

double display_exposure(const Image& reference) {
    const Image rgb = to_float(with_channels(reference, 3));
    const double white = luminance_percentile(rgb.floats(), 0.995);
    return white > 0 ? 1 / white : 1;
}

Image encoded_for_display(const Image& linear, double exposure) {
    Image out = to_float(with_channels(linear, 3));
    for (float& v : out.floats()) v = static_cast<float>(encode_srgb(static_cast<double>(v) * exposure));
    return out;
}

LinearDifference compare_linear(const Image& reference, const Image& test, double tolerance, const Mask& mask) {
    const Image r_image = fitted_to(reference, reference);
    const Image t_image = fitted_to(test, reference);
    const auto r = r_image.floats();
    const auto t = t_image.floats();
    if (!mask.empty() && mask.size() != r.size() / 3) throw Error("a mask is not of the pictures' size");
    const auto width = static_cast<size_t>(reference.width);
    if (const Broken broken(r, mask); broken.values > 0)
        throw Error(fmt::format("the reference picture holds NaN or Inf (first at x {}, y {})", broken.pixel % width,
                                broken.pixel / width));
    LinearDifference result;
    if (const Broken broken(t, mask); broken.values > 0) {
        result.not_finite = broken.values;
        result.not_finite_x = static_cast<int>(broken.pixel % width);
        result.not_finite_y = static_cast<int>(broken.pixel / width);
        result.relative_mse = result.worst_block = result.max_difference = std::numeric_limits<double>::infinity();
        result.failing_fraction = 1;
        return result;
    }
    const Means r_mean(r, mask), t_mean(t, mask);
    result.map = Image(reference.width, reference.height, 1, Image::Type::f32);
    fill_errors(result, r, t, std::max(std::pow(0.1 * r_mean.all(), 2), 1e-24), tolerance, mask);
    result.mean_ratio = ratio(t_mean.all(), r_mean.all());
    for (size_t c = 0; c < 3; ++c) result.channel_mean_ratio[c] = ratio(t_mean.channel[c], r_mean.channel[c]);
    const Block worst = worst_block(std::as_const(result.map).floats(), reference.width, reference.height, mask);
    result.worst_block = worst.mean;
    result.worst_block_x = worst.x;
    result.worst_block_y = worst.y;
    result.psnr_db = psnr(r, t, 1 / std::max(luminance_percentile(r, 0.995), 1e-12), mask);
    return result;
}

}  // namespace tyndall
