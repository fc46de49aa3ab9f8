#pragma once
/// The templates of World. Included by world.h.

#include <new>
#include <type_traits>
#include <utility>

#include "ecs/world.h"

namespace tyndall {

template <class... C>
Entity World::create_with(C... components) {
    const std::array<ComponentId, sizeof...(C)> ids{registry_.find<C>()...};
    if (iterating()) {
        const Entity entity = create();
        size_t i = 0;
        (add(entity, ids[i++], &components), ...);
        return entity;
    }
    uint32_t target = 0;
    for (const ComponentId id : ids) target = table_with(target, id);
    const Entity entity = take_slot();
    place(entity, target);
    detail::Table& table = *tables_[target];
    const uint32_t row = slots_[entity.index].row;
    const auto put = [&](auto& component, ComponentId id) {
        using T = std::remove_reference_t<decltype(component)>;
        detail::Column& column = table.columns()[table.column_of(id)];
        new (reinterpret_cast<T*>(column.data()) + row) T(std::move(component));
    };
    size_t i = 0;
    (put(components, ids[i++]), ...);
    return entity;
}

template <class T>
void World::add(Entity entity, T value) {
    add(entity, registry_.find<T>(), &value);
}

inline void* World::find(Entity entity, ComponentId id) {
    if (entity.index >= slots_.size()) return nullptr;
    const Slot slot = slots_[entity.index];
    if (slot.generation != entity.generation || slot.table >= kPending) return nullptr;
    detail::Table& table = *tables_[slot.table];
    const uint16_t column = table.column_of(id);
    return column == detail::Table::kNoColumn ? nullptr : table.columns()[column].at(slot.row);
}

inline const void* World::find(Entity entity, ComponentId id) const {
    return const_cast<World*>(this)->find(entity, id);
}

template <class... C, class F>
void World::each(F&& f) {
    const Iteration iteration(*this);
    walk<C...>(f, std::index_sequence_for<C...>());
}

template <class... C, class F>
void World::each(F&& f) const {
    const_cast<World*>(this)->each<const C...>(std::forward<F>(f));
}

template <class... C, class F, size_t... I>
void World::walk(F& f, std::index_sequence<I...>) {
    [[maybe_unused]] const std::array<ComponentId, sizeof...(C)> ids{registry_.find<C>()...};
    for (const std::unique_ptr<detail::Table>& table : tables_) {
        if (table == nullptr || table->size() == 0) continue;
        [[maybe_unused]] const std::array<uint16_t, sizeof...(C)> columns{table->column_of(ids[I])...};
        if (((columns[I] == detail::Table::kNoColumn) || ...)) continue;
        walk_rows<C...>(f, table->entities(), table->size(),
                        reinterpret_cast<C*>(table->columns()[columns[I]].data())...);
    }
}

template <class... C, class F>
void World::walk_rows(F& f, const Entity* entities, size_t count, C*... columns) {
    for (size_t row = 0; row < count; ++row) f(entities[row], columns[row]...);
}

}  // namespace tyndall
