#pragma once
/// Leaving out what a view cannot show.

#include <array>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include "geometry/mesh.h"

namespace tyndall {

/// The side planes and the far plane of a reversed-Z view. The near plane is not among them: what lies in front of it
/// still casts shadows where depth is clamped.
class Frustum {
 public:
    explicit Frustum(const glm::mat4& clip_from_world) {
        const glm::mat4 rows = glm::transpose(clip_from_world);
        planes_ = {rows[3] + rows[0], rows[3] - rows[0], rows[3] + rows[1], rows[3] - rows[1], rows[2]};
    }

    /// False only when the box is surely outside.
    [[nodiscard]] bool touches(const Bounds& box) const {
        for (const glm::vec4& plane : planes_) {
            const glm::vec3 normal(plane);
            const glm::vec3 farthest = glm::mix(box.low, box.high, glm::greaterThanEqual(normal, glm::vec3(0.0f)));
            if (glm::dot(normal, farthest) + plane.w < 0.0f) return false;
        }
        return true;
    }

 private:
    std::array<glm::vec4, 5> planes_;
};

}  // namespace tyndall
