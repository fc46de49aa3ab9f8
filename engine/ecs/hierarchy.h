#pragma once
/// Who is whose child.

#include <cstdint>
#include <span>
#include <vector>

#include "ecs/entity.h"
#include "ecs/side_table.h"

namespace tyndall::detail {

/// Parents and children by entity index; entities without either have no entry.
class Hierarchy {
 public:
    [[nodiscard]] Entity parent(uint32_t index) const;
    /// In the order in which they became children.
    [[nodiscard]] std::span<const Entity> children(uint32_t index) const;
    /// Puts `child` last below `parent`; a null parent makes it a root. False, and no change, when `parent` is `child`
    /// or lies below it.
    bool set_parent(Entity child, Entity parent);
    /// Forgets the entity and all below it. Returns those below, ancestors first.
    std::vector<Entity> erase(Entity entity);

 private:
    struct Node {
        Entity parent;
        std::vector<Entity> children;
    };
    [[nodiscard]] bool is_at_or_below(Entity entity, Entity ancestor) const;
    void unlink(Entity child);

    SideTable<Node> nodes_;
};

}  // namespace tyndall::detail
