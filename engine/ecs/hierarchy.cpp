#include "ecs/hierarchy.h"

#include <algorithm>

namespace tyndall::detail {

Entity Hierarchy::parent(uint32_t index) const {
    const Node* node = nodes_.find(index);
    return node ? node->parent : Entity{};
}

std::span<const Entity> Hierarchy::children(uint32_t index) const {
    const Node* node = nodes_.find(index);
    return node ? std::span<const Entity>(node->children) : std::span<const Entity>();
}

bool Hierarchy::set_parent(Entity child, Entity parent) {
    // A child without children is above nobody: long chains are built without climbing them.
    if (child == parent || (!children(child.index).empty() && is_at_or_below(parent, child))) return false;
    if (this->parent(child.index) == parent) return true;
    unlink(child);
    if (parent) {
        nodes_.obtain(parent.index).children.push_back(child);
        nodes_.obtain(child.index).parent = parent;
    }
    return true;
}

std::vector<Entity> Hierarchy::erase(Entity entity) {
    std::vector<Entity> below;
    if (nodes_.find(entity.index) == nullptr) return below;
    unlink(entity);
    const auto take = [&](Entity one) {
        const std::span<const Entity> its = children(one.index);
        below.insert(below.end(), its.begin(), its.end());
        nodes_.erase(one.index);
    };
    take(entity);
    for (size_t i = 0; i < below.size(); ++i) take(below[i]);
    return below;
}

bool Hierarchy::is_at_or_below(Entity entity, Entity ancestor) const {
    for (; entity; entity = parent(entity.index))
        if (entity == ancestor) return true;
    return false;
}

void Hierarchy::unlink(Entity child) {
    Node* node = nodes_.find(child.index);
    if (node == nullptr || !node->parent) return;
    const uint32_t above = node->parent.index;
    std::vector<Entity>& siblings = nodes_.find(above)->children;
    // From the back: what came last is what most often goes.
    const auto place = std::find(siblings.rbegin(), siblings.rend(), child);
    siblings.erase(std::next(place).base());
    node->parent = {};
    if (node->children.empty()) nodes_.erase(child.index);
    if (siblings.empty() && !parent(above)) nodes_.erase(above);
}

}  // namespace tyndall::detail
