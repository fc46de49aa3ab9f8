#pragma once
// Vertices in the same place, for the sources of this floor: UV seams and creases split vertices, not surfaces.

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

namespace tyndall {

/// For each vertex a number that it shares with all vertices in the same place; returns how many places there are.
size_t number_places(const std::vector<glm::vec3>& positions, std::vector<std::uint32_t>& places);

}  // namespace tyndall
