#pragma once
/// FLIP on linear colours: what LDR-FLIP and HDR-FLIP share.

#include "image/compare.h"

namespace tyndall::flip {

/// Throws Error when the pictures do not fit each other or FLIP.
void check(const Image& reference, const Image& test, float pixels_per_degree);

/// FLIP's map for two f32 pictures of three channels of linear sRGB in 0..1.
[[nodiscard]] Image map_of(const Image& reference, const Image& test, float pixels_per_degree);

/// Mean, maximum and worst block of a map, over what counts.
[[nodiscard]] FlipDifference pooled(Image map, const Mask& mask);

}  // namespace tyndall::flip
