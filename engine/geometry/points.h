#pragma once
/// Clouds of points from PLY files.

#include <glm/vec3.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace tyndall {

struct Point {
    glm::vec3 place{0.0f};
    float radius = 0.0f;  ///< the vertex' property `radius`; 0 where there is none
};

/// The vertices of a PLY file, text or binary; what else is in it is passed over. Throws Error, with the line where
/// there are lines, also for places that are not finite.
[[nodiscard]] std::vector<Point> read_points(std::string_view content, const std::string& source);

}  // namespace tyndall
