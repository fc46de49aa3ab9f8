#include "module/kept_state.h"

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>

#include "core/log.h"
#include "scene/scene_file.h"

namespace tyndall {
namespace {

using Json = nlohmann::ordered_json;

/// A component of one entity of one world.
struct Place {
    const World* world;
    uint32_t index, generation;
    std::string component;
    auto operator<=>(const Place&) const = default;
};

Json parsed(const std::string& text) {
    return text.empty() ? Json::object() : Json::parse(text);
}

/// Puts the values of now over what is kept and leaves the fields that `type` does not know, in nested objects too.
/// Of a choice that was made anew nothing old is kept: it has one key.
void take(Json& kept, const Json& now, const StructType& type) {
    if (!kept.is_object()) kept = Json::object();
    for (const auto& [key, value] : now.items()) {
        const Field* field = type.find(key);
        Json& old = kept[key];
        if (field && field->kind == FieldKind::structure && value.is_object()) {
            take(old, value, *field->type);
        } else if (field && field->kind == FieldKind::choice && value.size() == 1 && old.is_object() &&
                   old.contains(value.begin().key())) {
            const auto at = std::ranges::find(field->names, value.begin().key()) - field->names.begin();
            take(old.begin().value(), value.begin().value(), *field->alternatives.at(static_cast<size_t>(at)));
        } else {
            old = value;
        }
    }
}

void report(const std::vector<Diagnostic>& problems, const std::string& name) {
    for (const Diagnostic& problem : problems) log::warning("{}: {}", name, problem.text());
}

}  // namespace

struct KeptState::Implementation {
    std::map<Place, Json> components;  ///< whole values while away, unknown fields while here
    std::map<std::string, Json> settings;
};

KeptState::KeptState() : self_(std::make_unique<Implementation>()) {}
KeptState::~KeptState() = default;

void KeptState::save(const ModuleHost& host, const Registration& registration) {
    for (const std::string& name : registration.components()) {
        const ComponentId id = host.components.find(name);
        const StructType& type = host.components.type(id);
        std::erase_if(self_->components, [&](const auto& entry) {  // the user has removed it since
            const Place& at = entry.first;
            return at.component == name && !std::as_const(*at.world).find({at.index, at.generation}, id);
        });
        for (World* world : host.worlds)
            for (const Entity entity : world->entities())
                if (const void* value = std::as_const(*world).find(entity, id))
                    take(self_->components[{world, entity.index, entity.generation, name}],
                         parsed(component_to_json(type, value)), type);
    }
    for (const std::string& name : registration.settings_names()) {
        const StructType& type = *host.settings.type(name);
        take(self_->settings[name], parsed(component_to_json(type, std::as_const(host.settings).find(name))), type);
    }
}

void KeptState::restore(ModuleHost& host, const Registration& registration) {
    for (auto place = self_->components.begin(); place != self_->components.end();) {
        const auto& [at, kept] = *place;
        const ComponentId id = host.components.find(at.component);
        World* const world = const_cast<World*>(at.world);
        const Entity entity{at.index, at.generation};
        const bool gone =
            std::find(host.worlds.begin(), host.worlds.end(), world) == host.worlds.end() || !world->alive(entity);
        if (!gone && id == ComponentId::none) {  // this version has no such component: it waits for one that has
            ++place;
            continue;
        }
        Json unknown = Json::object();
        if (!gone) {
            std::vector<Diagnostic> problems;
            unknown =
                parsed(component_from_json(host.components.type(id), world->add(entity, id), kept.dump(), problems));
            report(problems, at.component);
        }
        place->second = unknown;
        place = unknown.empty() ? self_->components.erase(place) : std::next(place);
    }
    for (const std::string& name : registration.settings_names()) {
        const auto kept = self_->settings.find(name);
        if (kept == self_->settings.end()) continue;
        std::vector<Diagnostic> problems;
        kept->second = parsed(
            component_from_json(*host.settings.type(name), host.settings.find(name), kept->second.dump(), problems));
        report(problems, name);
    }
}

}  // namespace tyndall
