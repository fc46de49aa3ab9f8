#pragma once
/// A person in the level: walks, climbs steps, slides along walls, falls. Bullet's character controller on the level's
/// triangles.

#include <cstdint>
#include <glm/vec3.hpp>
#include <memory>
#include <span>

namespace tyndall {

/// A triangle soup that does not move, and a capsule that walks in it. Metres, seconds, +Y up.
class Walker {
 public:
    struct Body {
        float height_m = 1.8f;
        float eye_m = 1.65f;
        float radius_m = 0.3f;
        float step_m = 0.35f;
        float slope_deg = 50.0f;
    };
    Walker();
    explicit Walker(const Body& body);
    ~Walker();

    /// Adds a mesh to what the walker collides with; positions in the world. Degenerate triangles do no harm.
    void add_collider(std::span<const glm::vec3> positions, std::span<const uint32_t> indices);
    void clear_colliders();
    [[nodiscard]] bool has_colliders() const;

    /// Puts the eye there, and the feet on the ground below, at once.
    void place(const glm::vec3& eye);
    /// Moves for `seconds` at `velocity` (its horizontal part; m/s), with gravity. Returns the eye.
    glm::vec3 walk(const glm::vec3& velocity, float seconds);
    void jump();
    /// Flight with collision: moves the eye as a small sphere that slides along walls. Returns the eye.
    [[nodiscard]] glm::vec3 fly(const glm::vec3& eye, const glm::vec3& displacement) const;

 private:
    struct Implementation;
    std::unique_ptr<Implementation> self_;
};

}  // namespace tyndall
