#pragma once
/// Measured phase functions from text files.

#include <filesystem>
#include <string_view>

#include "scene/scattering.h"

namespace tyndall {

/// Reads lines of a scattering angle in degrees and one value, or one for red, green and blue, with spaces, commas or
/// tabs between; '#' starts a comment. Angles rise from 0 (forward) to 180. The scale of the values does not matter:
/// each channel is normalised to integrate to 1 over the sphere. Throws Error with file and line for anything else.
[[nodiscard]] PhaseTable load_phase_table(const std::filesystem::path& file, std::string_view name);

/// Makes each channel of evenly spaced values, linear between them, integrate to 1 over the sphere. False when one is 0
/// everywhere, and then nothing is changed.
bool normalise(PhaseTable& table);

}  // namespace tyndall
