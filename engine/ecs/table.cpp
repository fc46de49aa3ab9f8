#include "ecs/table.h"

#include <algorithm>
#include <cstring>
#include <utility>

namespace tyndall::detail {

Column::Column(ComponentId id, const StructType& type)
    : id_(id), trivial_(type.trivial), size_(type.size), type_(&type) {}

Column::Column(Column&& other) noexcept
    : id_(other.id_),
      trivial_(other.trivial_),
      size_(other.size_),
      type_(other.type_),
      data_(std::exchange(other.data_, nullptr)) {}

Column::~Column() {
    std::free(data_);
}

void Column::grow(size_t count, size_t capacity) {
    auto* grown = static_cast<std::byte*>(allocate_array(capacity * size_, type_->alignment));
    std::byte* old = std::exchange(data_, grown);
    if (trivial_ && count > 0)
        std::memcpy(data_, old, count * size_);
    else
        for (size_t row = 0; row < count; ++row) relocate(row, old + row * size_);
    std::free(old);
}

void Column::relocate(size_t row, void* from) {
    if (trivial_) {
        std::memcpy(at(row), from, size_);
        return;
    }
    type_->move_construct(at(row), from);
    type_->destroy(from);
}

Table::Table(std::vector<ComponentId> ids, const ComponentRegistry& registry) : ids_(std::move(ids)) {
    toggled.fill(kNoTable);
    column_of_.fill(kNoColumn);
    columns_.reserve(ids_.size());
    for (const ComponentId id : ids_) {
        column_of_[static_cast<size_t>(id)] = static_cast<uint16_t>(columns_.size());
        columns_.emplace_back(id, registry.type(id));
    }
}

Table::~Table() {
    for (Column& column : columns_)
        if (!column.type().trivial)
            for (size_t row = 0; row < size(); ++row) column.destroy(row);
}

Entity Table::erase(uint32_t row) {
    for (Column& column : columns_) column.destroy(row);
    return vacate(row);
}

Entity Table::vacate(uint32_t row) {
    const size_t last = size() - 1;
    Entity moved;
    if (row != last) {
        for (Column& column : columns_) column.relocate(row, column.at(last));
        moved = entities_[row] = entities_[last];
    }
    entities_.pop_back();
    return moved;
}

void Table::grow() {
    constexpr size_t kFirstCapacity = 16;
    const size_t capacity = std::max(kFirstCapacity, 2 * capacity_);
    entities_.reserve(capacity);
    for (Column& column : columns_) column.grow(size(), capacity);
    capacity_ = capacity;
}

}  // namespace tyndall::detail
