#pragma once
/// Three channels as one number.

#include <algorithm>
#include <glm/vec3.hpp>

namespace tyndall::reference {

[[nodiscard]] inline float mean_of(const glm::vec3& v) {
    return (v.x + v.y + v.z) / 3.0f;
}
[[nodiscard]] inline float largest(const glm::vec3& v) {
    return std::max(v.x, std::max(v.y, v.z));
}

}  // namespace tyndall::reference
