#pragma once
/// Pictures in the forms that a page reads without network.

#include <cstddef>
#include <span>
#include <string>

#include "report/report.h"

namespace tyndall::report {

[[nodiscard]] std::string base64(std::span<const std::byte> bytes);

/// The factor from scene-linear to a display's 0..1 that an entry asks for, or the automatic one.
[[nodiscard]] double exposure_of(const Entry& entry);

/// sqrt of the relative squared error per pixel: |t - r| / sqrt(r^2 + (0.1 mean r)^2), root mean square over the
/// channels; 1 where the test is not finite.
[[nodiscard]] Image relative_error(const Image& reference, const Image& test);

/// 8-bit sRGB for people: times `exposure`, clipped; NaN and Inf are magenta.
[[nodiscard]] Image developed(const Image& linear, double exposure);
/// Shrunk to at most `width` pixels wide.
[[nodiscard]] Image thumbnail(const Image& picture, int width);

/// JavaScript that hands an entry's numbers to the page: f32, or f16 times a power of two beyond kLargestF32 pixels,
/// in base64.
[[nodiscard]] std::string pixel_script(const Entry& entry, const std::string& id);
inline constexpr size_t kLargestF32 = size_t{1} << 18;

}  // namespace tyndall::report
