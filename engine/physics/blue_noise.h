#pragma once
/// A dither mask whose error eyes do not see: neighbouring values differ as much as they can.

#include <vector>

namespace tyndall::physics {

/// Side of the mask.
inline constexpr int kBlueNoiseSize = 64;

/// A tileable mask of kBlueNoiseSize^2 values (i + 0.5) / count, each once, row by row: void-and-cluster (Ulichney
/// 1993). Deterministic; takes some 130 ms.
[[nodiscard]] std::vector<float> blue_noise_mask();

}  // namespace tyndall::physics
