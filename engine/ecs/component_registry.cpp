#include "ecs/component_registry.h"

#include <algorithm>
#include <utility>

#include "core/error.h"

namespace tyndall {

ComponentRegistry::ComponentRegistry() = default;
ComponentRegistry::~ComponentRegistry() = default;

ComponentId ComponentRegistry::add(std::shared_ptr<const StructType> type, std::string owner) {
    const uint64_t hash = detail::name_hash(type->name);
    if (const ComponentId taken = find_hash(hash); taken != ComponentId::none)
        throw Error("component '" + type->name + "' of " + owner + " clashes with '" + this->type(taken).name +
                    "', registered by " + this->owner(taken));
    if (ids_.size() == kMaximumTypes)
        throw Error("component '" + type->name + "' of " + owner + " is one too many: there can be " +
                    std::to_string(kMaximumTypes) + " types");

    const auto is_free = [](const Entry& entry) { return entry.type == nullptr; };
    const auto place = std::find_if(entries_.begin(), entries_.end(), is_free);
    const auto id = static_cast<ComponentId>(place - entries_.begin());
    ids_.push_back(id);
    if (place == entries_.end())
        entries_.push_back({std::move(type), std::move(owner)});
    else
        *place = {std::move(type), std::move(owner)};
    insert(hash, id);
    return id;
}

void ComponentRegistry::remove(ComponentId id) {
    (void)entry(id);  // throws when there is none
    entries_[static_cast<size_t>(id)] = {};
    std::erase(ids_, id);
    buckets_.fill({});
    for (const ComponentId left : ids_) insert(detail::name_hash(type(left).name), left);
}

void ComponentRegistry::insert(uint64_t hash, ComponentId id) {
    size_t i = hash % kBuckets;
    while (buckets_[i].hash != 0) i = (i + 1) % kBuckets;
    buckets_[i] = {hash, id};
}

ComponentId ComponentRegistry::find(std::string_view name) const {
    const ComponentId id = find_hash(detail::name_hash(name));
    return id != ComponentId::none && type(id).name == name ? id : ComponentId::none;
}

const ComponentRegistry::Entry& ComponentRegistry::entry(ComponentId id) const {
    const auto i = static_cast<size_t>(id);
    if (i >= entries_.size() || entries_[i].type == nullptr)
        throw Error("there is no component type with id " + std::to_string(i));
    return entries_[i];
}

const StructType& ComponentRegistry::type(ComponentId id) const {
    return *entry(id).type;
}

const std::string& ComponentRegistry::owner(ComponentId id) const {
    return entry(id).owner;
}

std::span<const ComponentId> ComponentRegistry::ids() const {
    return ids_;
}

std::vector<std::string> ComponentRegistry::names() const {
    std::vector<std::string> names;
    names.reserve(ids_.size());
    for (const ComponentId id : ids_) names.push_back(type(id).name);
    return names;
}

}  // namespace tyndall
