#pragma once
/// Soft spheres that make up smoke, spray or dust: from files, and as a density on a grid.

#include <cstdint>
#include <filesystem>
#include <glm/vec3.hpp>
#include <span>
#include <string>
#include <vector>

#include "image/volume.h"

namespace tyndall {

/// A ball whose density is weight (1 - (distance / radius)^2)^2.
struct Particle {
    glm::vec3 centre{0.0f};
    float radius_m = 0.1f;  ///< 0 or less: the file has none
    float weight = 1.0f;
};

/// Particles from a file, shared. `id` as for MeshAsset.
struct ParticleAsset {
    uint64_t id = 0;
    std::string name;
    std::vector<Particle> particles;
};

/// Reads the vertices of a PLY file, with their property `radius` where there is one, or a text file of lines
/// `x y z [radius [weight]]` with # before comments. Throws Error with the file, and the line where known.
[[nodiscard]] std::vector<Particle> load_particles(const std::filesystem::path& file);

/// The sum of the particles' densities on cubic voxels, `resolution` of them along the longest edge of the box that
/// holds all balls. Balls smaller than a voxel are widened, and thinned to the same amount. Throws Error where there is
/// no particle with a place, a radius and a weight.
[[nodiscard]] Volume rasterised(std::span<const Particle> particles, int resolution);

}  // namespace tyndall
