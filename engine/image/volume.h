#pragma once
/// A scalar on a grid of voxels, and reading it from OpenVDB and raw files.

#include <cstdint>
#include <filesystem>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <string_view>
#include <vector>

namespace tyndall {

/// Dense values of a grid, x fastest, then y, then z. Values lie at voxel centres.
struct Volume {
    glm::ivec3 size{0};         ///< voxels along x, y, z
    glm::vec3 voxel_m{1.0f};    ///< edge lengths of a voxel as the file has them; only their ratios matter for fitting
    glm::vec3 low_m{0.0f};      ///< the low corner of its box in the file's own space, in the same units
    std::vector<float> values;  ///< size.x * size.y * size.z, finite, not negative

    [[nodiscard]] float at(int x, int y, int z) const {
        return values[(static_cast<size_t>(z) * static_cast<size_t>(size.y) + static_cast<size_t>(y)) *
                          static_cast<size_t>(size.x) +
                      static_cast<size_t>(x)];
    }
};

/// From the file's own space to [0, 1]^3 over the volume's box.
[[nodiscard]] glm::mat4 to_unit_box(const Volume& volume);

/// A volume has at most so many voxels: a gigabyte of them.
inline constexpr int64_t kMaxVoxels = int64_t{1} << 28;
/// The grid that is read when none is named.
inline constexpr std::string_view kDefaultGrid = "density";

/// Reads an OpenVDB file (the active box of the float grid called `grid`; an empty name is kDefaultGrid) or a JSON
/// description of a raw file (docs/assets.md), which has no grids to name. Adds the files that it reads to `sources`,
/// also when it throws. Throws Error with the file and the reason when the file is neither, is broken, has no such grid
/// (with the nearest name), or is too large.
[[nodiscard]] Volume load_volume(const std::filesystem::path& file, std::string_view grid = {},
                                 std::vector<std::filesystem::path>* sources = nullptr);

}  // namespace tyndall
