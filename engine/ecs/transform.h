#pragma once
/// Where an entity is: the engine's own component for placement, and world matrices down the hierarchy.

#include <glm/gtc/quaternion.hpp>
#include <glm/mat4x4.hpp>

#include "ecs/world.h"

namespace tyndall {

/// Placement relative to the parent, in metres. +Y up, right-handed; cameras and lights look along local -Z.
struct Transform {
    static constexpr std::string_view kName = "transform";
    glm::vec3 translation{0.0f};
    glm::quat rotation{1.0f, 0.0f, 0.0f, 0.0f};
    glm::vec3 scale{1.0f};
    [[nodiscard]] glm::mat4 matrix() const;
};
void describe(StructBuilder<Transform>& d);

/// The world matrix that `update_world_matrices` made, and the previous frame's. Not authored, not saved.
struct WorldMatrix {
    static constexpr std::string_view kName = "world_matrix";
    glm::mat4 current{1.0f};
    glm::mat4 previous{1.0f};
};
void describe(StructBuilder<WorldMatrix>& d);

/// Brings every entity's WorldMatrix up to date from the Transforms of it and its ancestors (no Transform = identity).
/// `current` becomes `previous` first; new entities start with both equal.
void update_world_matrices(World& world);

}  // namespace tyndall
