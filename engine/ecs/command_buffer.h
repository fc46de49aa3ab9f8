#pragma once
/// Structural changes that wait for the end of an iteration.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "ecs/component_registry.h"
#include "ecs/entity.h"

namespace tyndall::detail {

/// One recorded change.
struct Command {
    enum class Kind : uint8_t { create, destroy, add, remove };
    Kind kind;
    ComponentId id;
    Entity entity;
    void* value;  ///< of an `add`: lies in the buffer; null = the default
};

/// Memory for values of any type until `reset`; blocks are kept for the next time.
class ValueArena {
 public:
    void* allocate(size_t size, size_t alignment);
    void reset();

 private:
    struct Block {
        std::unique_ptr<std::byte[]> data;
        size_t size;
    };
    std::vector<Block> blocks_;
    size_t block_ = 0;  ///< the one that is being filled
    size_t used_ = 0;   ///< of it
};

/// Records changes in order. Whoever applies them destroys the values.
class CommandBuffer {
 public:
    void record(Command::Kind kind, Entity entity, ComponentId id = ComponentId::none) {
        commands_.push_back({kind, id, entity, nullptr});
    }
    /// Moves `value` into the buffer when it is not null.
    void record_add(Entity entity, ComponentId id, const StructType& type, void* value);

    [[nodiscard]] bool empty() const { return commands_.empty(); }
    [[nodiscard]] const std::vector<Command>& commands() const { return commands_; }
    /// Forgets all commands; their values are gone by now.
    void clear();

 private:
    std::vector<Command> commands_;
    ValueArena values_;
};

}  // namespace tyndall::detail
