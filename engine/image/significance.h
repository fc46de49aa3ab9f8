#pragma once
/// Whether two noisy pictures differ by more than their noise.

#include "image/compare.h"

namespace tyndall {

/// A picture of which each value is a mean of random samples.
struct NoisyPicture {
    Image radiance;  ///< f32, three channels
    Image variance;  ///< of those means, the same form; zeros where a value is exact
};

/// Outcome of a Z-test over 8x8 blocks. Where the pictures differ by their noise alone, z is distributed as a standard
/// normal; each p is the probability of something at least as far off then.
struct ZTest {
    size_t tests = 0;  ///< blocks times channels that have noise
    /// Blocks times channels without any noise that differ all the same by more than 1e-5 of their mean; p is then 0.
    size_t exact_differences = 0;

    double worst = 0;       ///< z of the worst block and channel, with its sign; positive: the test is brighter
    int worst_x = 0;        ///< left pixel of that block
    int worst_y = 0;        ///< top pixel
    int worst_channel = 0;  ///< 0 = red
    double worst_p = 1;     ///< of the largest of so many independent |z| (Sidak): two-sided

    double mean_square = 0;  ///< mean z^2, about 1 where noise is all, of the channel with the largest
    double spread_p = 1;     ///< chi-square of the sum of z^2, the smallest of the channels, times 3 (Bonferroni)

    double mean_z = 0;  ///< z of the whole picture's mean, of the channel that is farthest off
    double mean_p = 1;  ///< two-sided, the smallest of the channels, times 3

    double critical = 0;     ///< |z| that chance exceeds with the probability `significance` ...
    double share_above = 0;  ///< ... and the share of the z that do

    double p = 1;  ///< of all three together: 3 times the smallest, at most 1

    Image map;  ///< f32, one channel: the largest |z| of the block's channels, in every pixel of the block
};

/// Z-test per 8x8 block (at the right and lower border: what there is) and channel over the pixels that count:
/// z = (mean_t - mean_r) / sqrt(var_t + var_r), where the variance of a block's mean is the sum of its pixels'
/// variances over the square of their number. Channels share their samples, so they are joined by Bonferroni's
/// inequality, not as if they were independent. The pictures differ at the significance s when p < s; two samples of
/// the same truth do so with a probability of at most s, as far as block means are normal: noise of few, heavy-tailed
/// samples is not. Throws Error for pictures that do not fit, and for a radiance or variance that is not finite, or a
/// variance below 0.
[[nodiscard]] ZTest z_test(const NoisyPicture& reference, const NoisyPicture& test, double significance = 0.01,
                           const Mask& mask = {});

/// The variance of a picture of which nothing is known but that each value's standard deviation is `noise` times it.
[[nodiscard]] Image variance_of_relative_noise(const Image& radiance, double noise);

}  // namespace tyndall
