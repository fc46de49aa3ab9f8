#pragma once
/// A scalar on a grid of voxels, and reading it from OpenVDB and raw files.

#include <compare>
#include <cstdint>
#include <filesystem>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <string>
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

/// What of a file is read.
struct GridChoice {
    GridChoice() = default;
    GridChoice(std::string_view grid) : name(grid) {}
    GridChoice(const char* grid) : name(grid) {}
    auto operator<=>(const GridChoice&) const = default;

    std::string name;        ///< of a grid of floats; empty = kDefaultGrid
    std::string velocity;    ///< of a grid of vectors that blurs it, the file's units a second; empty = none
    float shutter_s = 0.0f;  ///< how long the grid moves
};

/// Reads an OpenVDB file (the active box of a grid of floats) or a JSON description of a raw file (docs/assets.md),
/// which has no grids to name. Adds the files that it reads to `sources`, also when it throws. Throws Error with the
/// file and the reason when the file is neither, is broken, has no such grid (with the nearest name), or is too large.
[[nodiscard]] Volume load_volume(const std::filesystem::path& file, const GridChoice& grid = {},
                                 std::vector<std::filesystem::path>* sources = nullptr);

/// What stays open for `shutter_s` sees of a volume whose voxels move, a velocity each in the file's units a second:
/// the mean over that time, around the volume's own, each place looking back along its own velocity (velocities do not
/// change while the shutter is open). What is carried out of the box is lost. At most kMostBlurSteps places are looked
/// at for a voxel; a grid that moves by more voxels than that shows them.
[[nodiscard]] Volume blurred_by_motion(const Volume& volume, std::span<const glm::vec3> velocity, float shutter_s);
inline constexpr int kMostBlurSteps = 64;

}  // namespace tyndall
