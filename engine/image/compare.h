#pragma once
/// How far one picture is from another: on scene-linear values, and as a person would see it (FLIP).

#include "image/image.h"

namespace tyndall {

/// Differences of two scene-linear pictures over their first three channels.
struct LinearDifference {
    /// mean((t-r)^2 / (r^2 + (0.1 mean r)^2)); infinite when the test picture holds NaN or Inf.
    double relative_mse = 0;
    double mean_ratio = 1;                     ///< mean(test) / mean(reference)
    double channel_mean_ratio[3] = {1, 1, 1};  ///< the same for red, green and blue
    double max_difference = 0;                 ///< largest |t-r|
    double failing_fraction = 0;  ///< share of the pixels whose sqrt(relative squared error) is above the tolerance
    double worst_block = 0;       ///< the largest mean relative squared error of an 8x8 block ...
    int worst_block_x = 0;        ///< ... and the left and ...
    int worst_block_y = 0;        ///< ... top pixel of that block
    double psnr_db = 0;           ///< of sRGB-encoded values with the reference's 99.5th luminance percentile at 1
    size_t not_finite = 0;        ///< NaN or Inf values in the test picture
};

/// `test` may be a whole multiple of the reference's size: it is box-filtered down. Throws Error when the sizes do not
/// fit, a picture has fewer than 3 channels, or the reference holds NaN or Inf.
[[nodiscard]] LinearDifference compare_linear(const Image& reference, const Image& test, double tolerance = 0.1);

/// What FLIP says of two display-encoded pictures.
struct FlipDifference {
    Image map;               ///< f32, one channel: 0 = the same, 1 = as different as can be
    double mean = 0;         ///< over the map
    double max = 0;          ///< over the map
    double worst_block = 0;  ///< the largest mean of an 8x8 block ...
    int worst_block_x = 0;   ///< ... and the left and ...
    int worst_block_y = 0;   ///< ... top pixel of that block
};

/// The difference that a person sees when the pictures alternate in place: LDR-FLIP (Andersson et al., "FLIP: A
/// Difference Evaluator for Alternating Images", HPG 2020). Both pictures sRGB-encoded, 0..1 (clamped), of the same
/// size, at least 3 channels; integer types are taken as 0..1. `pixels_per_degree` of the eye's view: 67 is a 0.7 m
/// wide, 3840 pixel display seen from 0.7 m. Throws Error for pictures that do not fit or hold NaN.
[[nodiscard]] FlipDifference compare_flip(const Image& reference, const Image& test, float pixels_per_degree = 67.0f);

/// A map of 0..1 as colours for people (black, violet, orange, pale yellow), 8-bit RGB.
[[nodiscard]] Image heat_map(const Image& map);

}  // namespace tyndall
