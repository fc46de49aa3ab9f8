#include "scene/settings.h"

#include <algorithm>

#include "core/error.h"
#include "scene/struct_object.h"

namespace tyndall {

struct Settings::Implementation {
    struct Entry {
        std::shared_ptr<const StructType> type;
        std::string owner;
        StructObject value;
    };
    std::vector<Entry> entries;

    [[nodiscard]] Entry* find(std::string_view name) {
        const auto found =
            std::ranges::find(entries, name, [](const Entry& e) -> std::string_view { return e.type->name; });
        return found == entries.end() ? nullptr : &*found;
    }
};

Settings::Settings() : self_(std::make_unique<Implementation>()) {}
Settings::~Settings() = default;

void Settings::add(std::shared_ptr<const StructType> type, std::string owner) {
    if (const auto* taken = self_->find(type->name))
        throw Error("settings '" + type->name + "' of " + owner + " are there already: " + taken->owner +
                    " has added them");
    StructObject value(*type);
    self_->entries.push_back({std::move(type), std::move(owner), std::move(value)});
}

void Settings::remove(std::string_view name) {
    std::erase_if(self_->entries, [&](const Implementation::Entry& entry) { return entry.type->name == name; });
}

void* Settings::find(std::string_view name) {
    auto* entry = self_->find(name);
    return entry ? entry->value.get() : nullptr;
}

const void* Settings::find(std::string_view name) const {
    return const_cast<Settings*>(this)->find(name);
}

const StructType* Settings::type(std::string_view name) const {
    const auto* entry = self_->find(name);
    return entry ? entry->type.get() : nullptr;
}

std::string Settings::owner(std::string_view name) const {
    const auto* entry = self_->find(name);
    return entry ? entry->owner : std::string{};
}

std::vector<std::string> Settings::names() const {
    std::vector<std::string> names;
    for (const auto& entry : self_->entries) names.push_back(entry.type->name);
    return names;
}

void Settings::reset() {
    for (auto& entry : self_->entries) {  // in place: references to the objects stay good
        entry.type->destroy(entry.value.get());
        entry.type->construct(entry.value.get());
    }
}

uint64_t Settings::fingerprint() const {
    uint64_t hash = self_->entries.size();
    for (const auto& entry : self_->entries) {
        if (!entry.type->trivial) continue;
        const std::string_view bytes(static_cast<const char*>(entry.value.get()), entry.type->size);
        hash = hash * 0x9e3779b97f4a7c15u + std::hash<std::string_view>{}(bytes);
    }
    return hash;
}

}  // namespace tyndall
