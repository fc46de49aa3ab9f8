#pragma once
/// The readers behind load_volume, each in its own .cpp for the weight of its library's headers.

#include <filesystem>
#include <string_view>
#include <vector>

#include "image/volume.h"

namespace tyndall {

/// The grid of an OpenVDB file, read in a process of its own (image/isolated.h): OpenVDB overruns its buffers where a
/// block's size is wrong. Throws Error.
[[nodiscard]] Volume load_vdb(const std::filesystem::path& file, std::string_view grid);
/// The vectors of a grid of an OpenVDB file at the middles of `like`'s voxels, linear between the grid's own. Throws
/// Error.
[[nodiscard]] std::vector<glm::vec3> load_vdb_vectors(const std::filesystem::path& file, std::string_view grid,
                                                      const Volume& like);
/// The raw file that the JSON `description` describes; `file` is where that was read. Adds the raw file to `sources`.
/// Throws Error.
[[nodiscard]] Volume load_raw_volume(const std::filesystem::path& file, std::string_view description,
                                     std::vector<std::filesystem::path>& sources);
/// Throws Error naming `file` when a volume of that size has no voxels or too many.
void check_volume_size(const std::filesystem::path& file, int64_t x, int64_t y, int64_t z);

}  // namespace tyndall
