#pragma once
/// All that is said of how far a picture is from its reference, under stable names.

#include <map>
#include <span>
#include <string>
#include <vector>

#include "image/blocks.h"
#include "image/compare.h"
#include "image/significance.h"

namespace tyndall {

/// How pictures are compared.
struct ComparisonOptions {
    double tolerance = 0.1;           ///< of failing_fraction: root of a pixel's relative squared error
    float pixels_per_degree = 67.0f;  ///< of the eye's view, for FLIP
    double exposure_stops = 0;        ///< for FLIP and SSIM: stops above display_exposure(reference)
    double significance = 0.01;       ///< of the Z-test's share_above
    bool hdr_flip = true;             ///< the slowest metric: as many FLIPs as the reference has stops of range
    Mask mask;                        ///< of the reference's size; empty: all pixels count
};

/// What compare_pictures found.
struct Comparison {
    /// By name; metric_names() lists them. What is not there was not measured.
    std::map<std::string, double> metrics;
    bool finite = true;              ///< false: the test holds NaN or Inf, and nothing passes
    std::vector<std::string> notes;  ///< for people: where a NaN is, what the Z-test could not judge
    std::vector<Block> worst;        ///< blocks of the largest relative squared error, worst first, at most 8
    double exposure = 1;             ///< factor from scene-linear to the display's 0..1 that FLIP and SSIM saw
    Image test;                      ///< the test at the reference's size, three channels
    Image flip, hdr_flip, ssim, z;   ///< maps, f32, one channel; empty when not measured
};

/// Compares scene-linear pictures. The test may be a whole multiple of the reference's size (box-filtered). The Z-test
/// is made when the reference has a variance; a test without one counts as exact. Throws Error for pictures, variances
/// or a mask that do not fit, and for a reference that is not finite.
[[nodiscard]] Comparison compare_pictures(const NoisyPicture& reference, const NoisyPicture& test,
                                          const ComparisonOptions& options = {});

/// A metric that can be held against a limit.
struct Metric {
    const char* name;
    bool at_least;      ///< more is better
    const char* about;  ///< one line
};
/// Those of Comparison::metrics that have a better and a worse, in the order in which people read them.
[[nodiscard]] std::span<const Metric> metrics_with_limits();
/// Throws Error for a name that is not among them, with the nearest.
[[nodiscard]] const Metric& metric_called(const std::string& name);
/// Whether the comparison's metric is within the limit; one that was not measured, or NaN or Inf in the test, is not.
[[nodiscard]] bool holds(const Comparison& comparison, const Metric& metric, double limit);

}  // namespace tyndall
