#pragma once
/// The handle of an entity.

#include <cstdint>

namespace tyndall {

/// A generational handle: stays dead after its entity was destroyed, even when the slot is used again.
struct Entity {
    uint32_t index = 0xffffffff;
    uint32_t generation = 0;
    bool operator==(const Entity&) const = default;
    explicit operator bool() const { return index != 0xffffffff; }
};

}  // namespace tyndall
