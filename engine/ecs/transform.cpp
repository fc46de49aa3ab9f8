#include "ecs/transform.h"

#include <glm/gtc/matrix_transform.hpp>
#include <vector>

namespace tyndall {

glm::mat4 Transform::matrix() const {
    // Rotations come from users and from arithmetic: nearly unit, or (a mistake) zero.
    const float length = glm::length(rotation);
    const glm::quat unit = length > 1e-6f ? rotation / length : glm::quat(1.0f, 0.0f, 0.0f, 0.0f);
    const glm::mat3 axes = glm::mat3_cast(unit);
    return {glm::vec4(axes[0] * scale.x, 0.0f), glm::vec4(axes[1] * scale.y, 0.0f), glm::vec4(axes[2] * scale.z, 0.0f),
            glm::vec4(translation, 1.0f)};
}

void describe(StructBuilder<Transform>& d) {
    d.doc("Placement relative to the parent: scale, then rotation, then translation. +Y is up.");
    d.field("translation", &Transform::translation, "Position of the origin.").unit("m");
    d.field("rotation", &Transform::rotation, "Unit quaternion x y z w.").range(-1.0, 1.0);
    d.field("scale", &Transform::scale, "Factor along each local axis.");
}

void describe(StructBuilder<WorldMatrix>& d) {
    d.doc("Placement in the world, of this frame and the one before. Made by the engine; nothing to author.");
}

namespace {

/// Gives a WorldMatrix to those that have none yet, and returns them.
std::vector<Entity> add_missing(World& world) {
    size_t present = 0;
    world.each<const WorldMatrix>([&](Entity, const WorldMatrix&) { ++present; });
    std::vector<Entity> added;
    if (present == world.size()) return added;
    for (const Entity entity : world.entities()) {
        if (world.find<WorldMatrix>(entity)) continue;
        world.add<WorldMatrix>(entity);
        added.push_back(entity);
    }
    return added;
}

glm::mat4 local_matrix(const World& world, Entity entity) {
    const Transform* transform = world.find<Transform>(entity);
    return transform ? transform->matrix() : glm::mat4(1.0f);
}

void advance(WorldMatrix& matrix, const glm::mat4& current) {
    matrix.previous = matrix.current;
    matrix.current = current;
}

}  // namespace

void update_world_matrices(World& world) {
    const std::vector<Entity> added = add_missing(world);
    // Roots in storage order, then downwards with a stack of our own: each entity is visited once, however deep.
    std::vector<Entity> with_children;
    world.each<WorldMatrix>([&](Entity entity, WorldMatrix& matrix) {
        if (world.parent(entity)) return;
        advance(matrix, local_matrix(world, entity));
        if (!world.children(entity).empty()) with_children.push_back(entity);
    });
    while (!with_children.empty()) {
        const Entity parent = with_children.back();
        with_children.pop_back();
        const glm::mat4 above = world.find<WorldMatrix>(parent)->current;
        for (const Entity child : world.children(parent)) {
            advance(*world.find<WorldMatrix>(child), above * local_matrix(world, child));
            if (!world.children(child).empty()) with_children.push_back(child);
        }
    }
    for (const Entity entity : added) {
        WorldMatrix* matrix = world.find<WorldMatrix>(entity);
        matrix->previous = matrix->current;
    }
}

}  // namespace tyndall
