#include "ecs/command_buffer.h"

#include <algorithm>

namespace tyndall::detail {

void* ValueArena::allocate(size_t size, size_t alignment) {
    constexpr size_t kBlockSize = 1 << 16;
    for (; block_ < blocks_.size(); ++block_, used_ = 0) {
        void* place = blocks_[block_].data.get() + used_;
        size_t room = blocks_[block_].size - used_;
        if (std::align(alignment, size, place, room) == nullptr) continue;
        used_ = blocks_[block_].size - room + size;
        return place;
    }
    const size_t block_size = std::max(kBlockSize, size + alignment);
    blocks_.push_back({std::make_unique_for_overwrite<std::byte[]>(block_size), block_size});
    return allocate(size, alignment);
}

void ValueArena::reset() {
    block_ = used_ = 0;
}

void CommandBuffer::record_add(Entity entity, ComponentId id, const StructType& type, void* value) {
    record(Command::Kind::add, entity, id);
    if (value == nullptr) return;
    void* place = values_.allocate(type.size, type.alignment);
    type.move_construct(place, value);
    commands_.back().value = place;
}

void CommandBuffer::clear() {
    commands_.clear();
    values_.reset();
}

}  // namespace tyndall::detail
