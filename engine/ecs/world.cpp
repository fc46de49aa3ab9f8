#include "ecs/world.h"

#include <algorithm>
#include <string>
#include <utility>

#include "core/error.h"

namespace tyndall {

using detail::Column;
using detail::Command;
using detail::Table;

World::World(ComponentRegistry& registry) : registry_(registry) {
    obtain_table({});
}

World::~World() = default;

Entity World::create() {
    const Entity entity = take_slot();
    if (iterating())
        commands_.record(Command::Kind::create, entity);
    else
        place(entity, 0);
    return entity;
}

void World::destroy(Entity entity) {
    if (!alive(entity)) return;
    if (iterating()) {
        commands_.record(Command::Kind::destroy, entity);
        return;
    }
    for (const Entity below : hierarchy_.erase(entity)) destroy_one(below);
    destroy_one(entity);
}

std::vector<Entity> World::entities() const {
    std::vector<Entity> all;
    all.reserve(size_);
    for (uint32_t i = 0; i < slots_.size(); ++i)
        if (slots_[i].table != kFree) all.push_back({i, slots_[i].generation});
    return all;
}

void World::set_name(Entity entity, std::string name) {
    if (!alive(entity)) return;
    names_.set(entity.index, std::move(name));
    ++version_;
}

const std::string& World::name(Entity entity) const {
    return names_.of(alive(entity) ? entity.index : kFree);
}

Entity World::find_named(std::string_view name) const {
    const uint32_t index = names_.find(name);
    return index == kFree ? Entity{} : Entity{index, slots_[index].generation};
}

bool World::set_parent(Entity child, Entity parent) {
    if (!alive(child) || (parent && !alive(parent)) || !hierarchy_.set_parent(child, parent)) return false;
    ++version_;
    return true;
}

Entity World::parent(Entity entity) const {
    return alive(entity) ? hierarchy_.parent(entity.index) : Entity{};
}

std::span<const Entity> World::children(Entity entity) const {
    return alive(entity) ? hierarchy_.children(entity.index) : std::span<const Entity>();
}

void* World::add(Entity entity, ComponentId id, void* value) {
    const StructType& type = registry_.type(id);
    if (!alive(entity)) return nullptr;
    if (iterating()) {
        commands_.record_add(entity, id, type, value);
        return nullptr;
    }
    const auto construct = [&](void* at) { value ? type.move_construct(at, value) : type.construct(at); };
    if (void* present = find(entity, id)) {
        type.destroy(present);
        construct(present);
        return present;
    }
    const uint32_t target = toggle(slots_[entity.index].table, id);
    Table& table = *tables_[target];
    const uint32_t row = table.append(entity);
    void* place = table.columns()[table.column_of(id)].at(row);
    try {
        construct(place);
    } catch (...) {
        table.cancel();
        throw;
    }
    move(entity, target, row);
    return place;
}

void World::remove(Entity entity, ComponentId id) {
    if (!alive(entity)) return;
    if (iterating()) {
        if (id != ComponentId::none) commands_.record(Command::Kind::remove, entity, id);
        return;
    }
    if (find(entity, id) == nullptr) return;
    const uint32_t target = toggle(slots_[entity.index].table, id);
    move(entity, target, tables_[target]->append(entity));
}

std::vector<ComponentId> World::components(Entity entity) const {
    std::vector<ComponentId> ids;
    for (const ComponentId id : registry_.ids())
        if (find(entity, id) != nullptr) ids.push_back(id);
    return ids;
}

void World::drop_components(ComponentId id) {
    if (iterating()) throw Error("components cannot be dropped while iterating");
    const auto has_it = [&](const auto& table) { return table && table->column_of(id) != Table::kNoColumn; };
    // By index: `remove` may add the tables it moves entities to.
    for (size_t i = 0; i < tables_.size(); ++i)
        while (has_it(tables_[i]) && tables_[i]->size() > 0) remove(tables_[i]->entities()[tables_[i]->size() - 1], id);
    for (std::unique_ptr<Table>& table : tables_) {
        if (table) table->toggled.fill(Table::kNoTable);
        if (!has_it(table)) continue;
        table_by_ids_.erase(table->ids());
        table.reset();
    }
    ++version_;
}

void World::each(ComponentId id, void (*f)(void* context, Entity entity, void* component), void* context) {
    const Iteration iteration(*this);
    for (const std::unique_ptr<Table>& table : tables_) {
        const uint16_t place = table ? table->column_of(id) : Table::kNoColumn;
        if (place == Table::kNoColumn) continue;
        const Column& column = table->columns()[place];
        for (size_t row = 0; row < table->size(); ++row) f(context, table->entities()[row], column.at(row));
    }
}

Entity World::take_slot() {
    uint32_t index = first_free_;
    if (index == kFree) {
        index = static_cast<uint32_t>(slots_.size());
        slots_.emplace_back();
    } else {
        first_free_ = slots_[index].row;
    }
    slots_[index].table = kPending;
    ++size_;
    ++version_;
    return {index, slots_[index].generation};
}

void World::place(Entity entity, uint32_t table) {
    Slot& slot = slots_[entity.index];
    slot.row = tables_[table]->append(entity);
    slot.table = table;
}

void World::destroy_one(Entity entity) {
    Slot& slot = slots_[entity.index];
    if (slot.table != kPending)
        if (const Entity moved = tables_[slot.table]->erase(slot.row)) slots_[moved.index].row = slot.row;
    names_.erase(entity.index);
    slot.table = kFree;
    --size_;
    ++version_;
    // A slot whose generations are used up stays free for ever, so that no old handle comes to life again.
    if (++slot.generation == 0xffffffff) return;
    slot.row = std::exchange(first_free_, entity.index);
}

uint32_t World::toggle(uint32_t table, ComponentId id) {
    const auto slot = static_cast<size_t>(id);
    if (tables_[table]->toggled[slot] == Table::kNoTable) {
        std::vector<ComponentId> ids = tables_[table]->ids();
        const auto place = std::lower_bound(ids.begin(), ids.end(), id);
        if (place != ids.end() && *place == id)
            ids.erase(place);
        else
            ids.insert(place, id);
        const uint32_t other = obtain_table(std::move(ids));
        tables_[table]->toggled[slot] = other;
        tables_[other]->toggled[slot] = table;
    }
    return tables_[table]->toggled[slot];
}

uint32_t World::table_with(uint32_t table, ComponentId id) {
    if (id == ComponentId::none) (void)registry_.type(id);  // throws
    return toggle(table, id);
}

uint32_t World::obtain_table(std::vector<ComponentId> ids) {
    if (const auto known = table_by_ids_.find(ids); known != table_by_ids_.end()) return known->second;
    const auto gap = std::find(tables_.begin(), tables_.end(), nullptr);
    const auto place = static_cast<uint32_t>(gap - tables_.begin());
    auto table = std::make_unique<Table>(ids, registry_);
    if (gap == tables_.end())
        tables_.push_back(std::move(table));
    else
        *gap = std::move(table);
    table_by_ids_.emplace(std::move(ids), place);
    return place;
}

void World::move(Entity entity, uint32_t target, uint32_t row) {
    Slot& slot = slots_[entity.index];
    Table& from = *tables_[slot.table];
    Table& to = *tables_[target];
    for (Column& column : from.columns()) {
        const uint16_t place = to.column_of(column.id());
        if (place == Table::kNoColumn)
            column.destroy(slot.row);
        else
            to.columns()[place].relocate(row, column.at(slot.row));
    }
    if (const Entity moved = from.vacate(slot.row)) slots_[moved.index].row = slot.row;
    slot.table = target;
    slot.row = row;
    ++version_;
}

void World::apply() {
    for (const Command& command : commands_.commands()) {
        switch (command.kind) {
            case Command::Kind::create:
                if (slots_[command.entity.index].table == kPending) place(command.entity, 0);
                break;
            case Command::Kind::destroy:
                destroy(command.entity);
                break;
            case Command::Kind::add:
                add(command.entity, command.id, command.value);
                if (command.value) registry_.type(command.id).destroy(command.value);
                break;
            case Command::Kind::remove:
                remove(command.entity, command.id);
                break;
        }
    }
    commands_.clear();
}

}  // namespace tyndall
