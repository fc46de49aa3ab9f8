#pragma once
/// Axis-aligned boxes.

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <limits>

namespace tyndall {

/// The smallest box that holds what was added; starts empty.
struct Bounds {
    glm::vec3 low{std::numeric_limits<float>::infinity()};
    glm::vec3 high{-std::numeric_limits<float>::infinity()};

    [[nodiscard]] bool empty() const { return !(low.x <= high.x && low.y <= high.y && low.z <= high.z); }
    [[nodiscard]] glm::vec3 centre() const { return 0.5f * (low + high); }
    [[nodiscard]] glm::vec3 size() const { return empty() ? glm::vec3(0.0f) : high - low; }
    /// Of the sphere around centre() that holds the box; 0 when empty.
    [[nodiscard]] float radius() const { return 0.5f * glm::length(size()); }
    [[nodiscard]] bool contains(glm::vec3 p) const { return glm::clamp(p, low, high) == p; }

    void add(glm::vec3 p) {
        low = glm::min(low, p);
        high = glm::max(high, p);
    }
    void merge(const Bounds& other) {
        low = glm::min(low, other.low);
        high = glm::max(high, other.high);
    }
    /// The box around this box after an affine transform; empty stays empty.
    [[nodiscard]] Bounds transformed(const glm::mat4& transform) const {
        if (empty()) return {};
        // Each axis of the box adds its extent's size, whatever its sign (Arvo, Graphics Gems, 1990).
        const glm::vec3 middle(transform * glm::vec4(centre(), 1.0f));
        const glm::vec3 half = 0.5f * size();
        const glm::vec3 extent = glm::abs(glm::vec3(transform[0])) * half.x +
                                 glm::abs(glm::vec3(transform[1])) * half.y +
                                 glm::abs(glm::vec3(transform[2])) * half.z;
        return {middle - extent, middle + extent};
    }
};

}  // namespace tyndall
