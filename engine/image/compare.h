#pragma once
/// How far one picture is from another: on scene-linear values, as a person would see it (FLIP), and in structure
/// (SSIM). docs/compare.md says what each is good for.

#include <cstdint>
#include <vector>

#include "image/image.h"

namespace tyndall {

/// Which pixels count: a byte for each, 0 = left out. Empty: all count.
using Mask = std::vector<std::uint8_t>;
/// The pixels of which red, green or blue (or grey) is not zero. Throws Error when none is.
[[nodiscard]] Mask mask_of(const Image& image);

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
    size_t not_finite = 0;        ///< NaN or Inf values in the test picture, the first of which ...
    int not_finite_x = 0;         ///< ... is at this pixel from the left ...
    int not_finite_y = 0;         ///< ... and this from the top
    Image map;                    ///< f32, one channel: relative squared error; empty when not finite
};

/// Over the pixels that count. `test` may be a whole multiple of the reference's size: it is box-filtered down. Throws
/// Error when the sizes do not fit, a picture has fewer than 3 channels, or the reference holds NaN or Inf.
[[nodiscard]] LinearDifference compare_linear(const Image& reference, const Image& test, double tolerance = 0.1,
                                              const Mask& mask = {});

/// The first three channels of `image` as f32, box-filtered to the reference's size. Throws Error when its size is no
/// whole multiple of the reference's, or it has fewer than 3 channels.
[[nodiscard]] Image fitted_to(const Image& image, const Image& reference);
/// The factor that brings the reference's 99.5th percentile of luminance (Rec.709) to 1; 1 for a black picture.
[[nodiscard]] double display_exposure(const Image& reference);
/// Scene-linear values times `exposure`, clipped to 0..1 and sRGB-encoded: f32, three channels.
[[nodiscard]] Image encoded_for_display(const Image& linear, double exposure);

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
/// The map is of all pixels, the numbers of those that count.
[[nodiscard]] FlipDifference compare_flip(const Image& reference, const Image& test, float pixels_per_degree = 67.0f,
                                          const Mask& mask = {});

/// What HDR-FLIP says of two scene-linear pictures.
struct HdrFlipDifference : FlipDifference {
    double start_exposure = 0;  ///< log2 of the shortest exposure's factor: the reference's brightest becomes 0.85
    double stop_exposure = 0;   ///< of the longest: its median becomes 0.85
    int exposures = 0;          ///< as many as there are stops between, at least 2
};

/// The largest difference that a person could see at any exposure: HDR-FLIP (Andersson et al., "Visualizing Errors in
/// Rendered High Dynamic Range Images", Eurographics 2021). Per pixel the maximum of LDR-FLIP over exposures that the
/// reference sets, after the ACES tone curve. Scene-linear sRGB, at least 3 channels, the same size. Where the paper's
/// longest exposure would be infinite (a picture that is mostly black) the median is that of the rest, and no exposure
/// is more than 24 stops above the shortest. Throws Error for pictures that do not fit or hold NaN or Inf.
[[nodiscard]] HdrFlipDifference compare_hdr_flip(const Image& reference, const Image& test,
                                                 float pixels_per_degree = 67.0f, const Mask& mask = {});

/// What SSIM says of two display-encoded pictures.
struct SsimDifference {
    Image map;         ///< f32, one channel: 1 = the same structure, down to -1
    double mean = 1;   ///< over the pixels whose whole window lies in the picture, as its authors have it
    double worst = 1;  ///< the smallest of those
};

/// Structural similarity of the luminance (Z. Wang et al., "Image Quality Assessment: From Error Visibility to
/// Structural Similarity", IEEE TIP 2004): Gaussian window of 11x11 pixels and 1.5 pixels' deviation, K1 = 0.01,
/// K2 = 0.03, dynamic range 1. Luminance is Rec.709's sum of the encoded values (luma). At the border the map repeats
/// the nearest pixel whose window fits; a picture smaller than the window is compared by windows that are cut off. The
/// pictures as compare_flip takes them. Throws Error for pictures that do not fit or hold NaN.
[[nodiscard]] SsimDifference compare_ssim(const Image& reference, const Image& test, const Mask& mask = {});

/// A map of 0..1 as colours for people (black, violet, orange, pale yellow), 8-bit RGB.
[[nodiscard]] Image heat_map(const Image& map);

}  // namespace tyndall
