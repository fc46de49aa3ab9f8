#include "image/comparison.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "core/error.h"

namespace tyndall {
namespace {

constexpr size_t kWorstBlocks = 8;

constexpr Metric kMetrics[] = {
    {"relmse", false, "mean((t-r)^2 / (r^2 + (0.1 mean r)^2))"},
    {"hdr_flip", false, "mean HDR-FLIP, 0 to 1"},
    {"flip", false, "mean LDR-FLIP at the display exposure, 0 to 1"},
    {"ssim", true, "mean structural similarity of the encoded luminance, up to 1"},
    {"psnr_db", true, "of sRGB-encoded values, the reference's 99.5th percentile at 1"},
    {"mean_error", false, "|mean(test) / mean(reference) - 1|"},
    {"max_difference", false, "largest |t-r| of a channel"},
    {"failing_fraction", false, "share of the pixels whose relative error is above the tolerance"},
    {"worst_block", false, "largest mean relative squared error of an 8x8 block"},
    {"flip_max", false, "largest LDR-FLIP of a pixel"},
    {"flip_worst_block", false, "largest mean LDR-FLIP of an 8x8 block"},
    {"hdr_flip_max", false, "largest HDR-FLIP of a pixel"},
    {"hdr_flip_worst_block", false, "largest mean HDR-FLIP of an 8x8 block"},
    {"ssim_min", true, "smallest structural similarity of a pixel"},
    {"not_finite", false, "NaN and Inf values in the test"},
    {"z_p", true, "probability that noise alone differs as much: the Z-test's verdict"},
    {"z_worst_p", true, "the same of the worst 8x8 block and channel"},
    {"z_spread_p", true, "the same of the spread of all blocks"},
    {"z_mean_p", true, "the same of the whole picture's mean"},
};

/// What a mask leaves out must not spread NaN through a filter.
void blank(Image& image, const Mask& mask) {
    const std::span<float> values = image.floats();
    for (size_t i = 0; i < values.size() && !mask.empty(); ++i)
        if (mask[i / 3] == 0 && !std::isfinite(values[i])) values[i] = 0;
}

/// The variance of means over factor x factor pixels.
Image fitted_variance(const Image& variance, const Image& reference) {
    if (variance.empty()) return Image(reference.width, reference.height, 3, Image::Type::f32);
    Image fitted = fitted_to(variance, reference);
    const auto factor = static_cast<float>(variance.width / reference.width);
    for (float& v : fitted.floats()) v /= factor * factor;
    return fitted;
}

void add_linear(Comparison& result, const LinearDifference& linear) {
    auto& m = result.metrics;
    m["not_finite"] = static_cast<double>(linear.not_finite);
    m["relmse"] = linear.relative_mse;
    m["max_difference"] = linear.max_difference;
    m["failing_fraction"] = linear.failing_fraction;
    m["worst_block"] = linear.worst_block;
    if (linear.not_finite > 0) {
        result.finite = false;
        result.notes.push_back(fmt::format("the test holds {} NaN or Inf values, the first at x {}, y {}",
                                           linear.not_finite, linear.not_finite_x, linear.not_finite_y));
        return;
    }
    m["psnr_db"] = linear.psnr_db;
    m["mean_ratio"] = linear.mean_ratio;
    m["mean_error"] = std::abs(linear.mean_ratio - 1);
    m["mean_ratio.r"] = linear.channel_mean_ratio[0];
    m["mean_ratio.g"] = linear.channel_mean_ratio[1];
    m["mean_ratio.b"] = linear.channel_mean_ratio[2];
}

void add_seen(Comparison& result, const Image& reference, const ComparisonOptions& options) {
    auto& m = result.metrics;
    const Image shown = encoded_for_display(reference, result.exposure);
    const Image test_shown = encoded_for_display(result.test, result.exposure);
    FlipDifference flip = compare_flip(shown, test_shown, options.pixels_per_degree, options.mask);
    m["flip"] = flip.mean;
    m["flip_max"] = flip.max;
    m["flip_worst_block"] = flip.worst_block;
    result.flip = std::move(flip.map);
    SsimDifference ssim = compare_ssim(shown, test_shown, options.mask);
    m["ssim"] = ssim.mean;
    m["ssim_min"] = ssim.worst;
    result.ssim = std::move(ssim.map);
    if (!options.hdr_flip) return;
    HdrFlipDifference hdr = compare_hdr_flip(reference, result.test, options.pixels_per_degree, options.mask);
    m["hdr_flip"] = hdr.mean;
    m["hdr_flip_max"] = hdr.max;
    m["hdr_flip_worst_block"] = hdr.worst_block;
    result.hdr_flip = std::move(hdr.map);
}

void add_significance(Comparison& result, const NoisyPicture& reference, const Image& test_variance,
                      const ComparisonOptions& options) {
    ZTest z = z_test(reference, {result.test, fitted_variance(test_variance, reference.radiance)}, options.significance,
                     options.mask);
    auto& m = result.metrics;
    m["z_p"] = z.p;
    m["z_tests"] = static_cast<double>(z.tests);
    m["z_worst"] = z.worst;
    m["z_worst_p"] = z.worst_p;
    m["z_worst_x"] = z.worst_x;
    m["z_worst_y"] = z.worst_y;
    m["z_spread"] = z.mean_square;
    m["z_spread_p"] = z.spread_p;
    m["z_mean"] = z.mean_z;
    m["z_mean_p"] = z.mean_p;
    m["z_share"] = z.share_above;
    m["z_critical"] = z.critical;
    if (z.exact_differences > 0)
        result.notes.push_back(
            fmt::format("{} blocks differ where neither picture has any noise", z.exact_differences));
    if (test_variance.empty()) result.notes.emplace_back("Z-test: the test has no variance and counts as exact");
    result.z = std::move(z.map);
}

}  // namespace

Comparison compare_pictures(const NoisyPicture& reference, const NoisyPicture& test, const ComparisonOptions& options) {
    Comparison result;
    NoisyPicture r{fitted_to(reference.radiance, reference.radiance), {}};
    result.test = fitted_to(test.radiance, r.radiance);
    const LinearDifference linear = compare_linear(r.radiance, result.test, options.tolerance, options.mask);
    add_linear(result, linear);
    result.exposure = display_exposure(r.radiance) * std::exp2(options.exposure_stops);
    if (!result.finite) return result;
    result.worst = worst_blocks(linear.map.floats(), linear.map.width, linear.map.height, kWorstBlocks, options.mask);
    blank(r.radiance, options.mask);
    blank(result.test, options.mask);
    add_seen(result, r.radiance, options);
    if (reference.variance.empty()) return result;
    r.variance = fitted_variance(reference.variance, r.radiance);
    add_significance(result, r, test.variance, options);
    return result;
}

std::span<const Metric> metrics_with_limits() {
    return kMetrics;
}

const Metric& metric_called(const std::string& name) {
    std::vector<std::string> names;
    for (const Metric& metric : kMetrics) {
        if (metric.name == name) return metric;
        names.emplace_back(metric.name);
    }
    throw Error(
        Diagnostic{{},
                   "unknown metric '" + name + "'",
                   "relmse, hdr_flip, flip, ssim, psnr_db, mean_error, max_difference, failing_fraction, z_p, ...",
                   nearest_name(name, names)});
}

bool holds(const Comparison& comparison, const Metric& metric, double limit) {
    const auto found = comparison.metrics.find(metric.name);
    if (!comparison.finite || found == comparison.metrics.end()) return false;
    return metric.at_least ? found->second >= limit : found->second <= limit;
}

}  // namespace tyndall
