#pragma once
/// What a reference's own noise looks like to a metric.

#include "image/significance.h"

namespace tyndall::measure {

/// The relMSE that a perfect picture has against this reference, in the mean: mean(variance / (r^2 + (0.1 mean r)^2)).
/// Negative, for unknown, without a variance. Throws Error for a variance of another size.
[[nodiscard]] double noise_floor(const NoisyPicture& reference);

}  // namespace tyndall::measure
