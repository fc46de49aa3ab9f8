#pragma once
/// Traced references as they are kept beside a capture file: compact, and with the recipe that made them.
///
/// NAME.exr holds R G B, variance.R G B and three text attributes: `tyndall.recipe` (JSON), `tyndall.samples`,
/// `tyndall.seed`. Numbers keep as many bits as their noise leaves worth keeping, which ZIP then packs:
///   - radiance is rounded to steps of at most half of its standard deviation, up or down at random, so that no mean
///     changes; what that adds to the noise is added to the variance. It is stored as half floats when the picture
///     fits into their range, otherwise as 32-bit ones, never scaled: any program reads true cd/m2.
///   - the variance, whose range is the square of the radiance's, is stored as 32-bit floats of 5 significant bits.

#include <cstdint>
#include <filesystem>
#include <string>

#include "app/capture_file.h"
#include "image/significance.h"

namespace tyndall {

/// NAME.exr beside the capture file.
[[nodiscard]] std::filesystem::path file_of(const CaptureFile& capture, const TracedReference& reference);

/// Writes a reference, atomically. Throws Error when it cannot be written, and for values that are not finite.
void save_reference(const std::filesystem::path& file, const NoisyPicture& picture, const std::string& recipe,
                    int64_t samples, int32_t seed);
/// A capture's reference. Throws Error when it is not there, broken, or was made from another recipe than recipe_of
/// says: with what is different, and how to make it again.
[[nodiscard]] NoisyPicture load_reference(const CaptureFile& capture, const TracedReference& reference);

}  // namespace tyndall
