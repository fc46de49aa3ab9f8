#pragma once
/// A scalar on a grid of voxels, and reading it from OpenVDB and raw files.

#include <filesystem>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

namespace tyndall {

/// Dense values of a grid, x fastest, then y, then z. Values lie at voxel centres.
struct Volume {
    glm::ivec3 size{0};        ///< voxels along x, y, z
    glm::vec3 voxel_m{1.0f};   ///< edge lengths of a voxel as the file has them; only their ratios matter for fitting
    std::vector<float> values;  ///< size.x * size.y * size.z, finite

    [[nodiscard]] float at(int x, int y, int z) const {
        return values[(static_cast<size_t>(z) * static_cast<size_t>(size.y) + static_cast<size_t>(y)) *
                          static_cast<size_t>(size.x) +
                      static_cast<size_t>(x)];
    }
};

}  // namespace tyndall
