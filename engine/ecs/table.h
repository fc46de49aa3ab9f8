#pragma once
/// Where components lie: one table for all entities with the same set of component types, one array per type.
///
/// Columns are single arrays that grow by doubling, not chunks: a view is one plain loop over them, and with huge pages
/// the copying that growth costs is a small part of creating entities (`bench_ecs` measures both).

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "ecs/array_memory.h"
#include "ecs/component_registry.h"
#include "ecs/entity.h"

namespace tyndall::detail {

/// A dense array of one component type, known by its description only. The table decides which rows hold values.
class Column {
 public:
    Column(ComponentId id, const StructType& type);
    Column(Column&& other) noexcept;
    Column& operator=(Column&&) = delete;
    ~Column();

    [[nodiscard]] ComponentId id() const { return id_; }
    [[nodiscard]] const StructType& type() const { return *type_; }
    [[nodiscard]] std::byte* data() const { return data_; }
    [[nodiscard]] void* at(size_t row) const { return data_ + row * size_; }

    /// Makes room for `capacity` rows, the first `count` of which hold values.
    void grow(size_t count, size_t capacity);
    /// Moves the value at `from` into the empty `row`; nothing is left at `from`.
    void relocate(size_t row, void* from);
    void destroy(size_t row) {
        if (!trivial_) type_->destroy(at(row));
    }

 private:
    ComponentId id_;
    bool trivial_;
    size_t size_;
    const StructType* type_;  ///< owned by the registry, which the column never outlives
    std::byte* data_ = nullptr;
};

/// All entities with exactly the component types `ids`.
class Table {
 public:
    static constexpr uint16_t kNoColumn = 0xffff;
    static constexpr uint32_t kNoTable = 0xffffffff;

    /// `ids` in ascending order.
    Table(std::vector<ComponentId> ids, const ComponentRegistry& registry);
    ~Table();
    Table(const Table&) = delete;
    Table& operator=(const Table&) = delete;

    [[nodiscard]] size_t size() const { return entities_.size(); }
    [[nodiscard]] const Entity* entities() const { return entities_.data(); }
    [[nodiscard]] const std::vector<ComponentId>& ids() const { return ids_; }
    [[nodiscard]] std::vector<Column>& columns() { return columns_; }
    /// The place in `columns` of a type, or kNoColumn; also for ComponentId::none.
    [[nodiscard]] uint16_t column_of(ComponentId id) const {
        const auto i = static_cast<size_t>(id);
        return i < column_of_.size() ? column_of_[i] : kNoColumn;
    }

    /// Adds a row for the entity; its columns hold no values yet.
    uint32_t append(Entity entity) {
        if (entities_.size() == capacity_) grow();
        entities_.push_back(entity);
        return static_cast<uint32_t>(entities_.size() - 1);
    }
    /// Takes back the row just appended, whose columns hold no values.
    void cancel() { entities_.pop_back(); }
    /// Destroys the row's values and fills the gap as `vacate` does.
    Entity erase(uint32_t row);
    /// Fills a row whose values have gone with the last one. Returns the entity that now lies there; null for the last.
    Entity vacate(uint32_t row);

    /// By type: the table that differs from this one in having, or not having, that type. A cache of the world's.
    std::array<uint32_t, ComponentRegistry::kMaximumTypes> toggled;

 private:
    void grow();

    std::vector<ComponentId> ids_;
    std::vector<Column> columns_;
    std::array<uint16_t, ComponentRegistry::kMaximumTypes> column_of_;
    std::vector<Entity, ArrayAllocator<Entity>> entities_;
    size_t capacity_ = 0;
};

}  // namespace tyndall::detail
