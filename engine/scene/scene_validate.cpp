#include <algorithm>
#include <iterator>

#include "core/log.h"
#include "scene/component_form.h"
#include "scene/scene_file_state.h"
#include "scene/scene_structure.h"
#include "scene/struct_object.h"

namespace tyndall {
namespace {

using Kind = JsonValue::Kind;

/// The camera that "render" asks for must be there: an entity with a camera of its own or from a glTF file.
void check_camera(const JsonDocument& document, Problems& problems) {
    const JsonMember* render = document.root.find("render");
    const JsonMember* camera = render ? render->value.find("camera") : nullptr;
    if (!camera || !camera->value.is(Kind::string) || camera->value.string.empty()) return;
    std::vector<std::string> names;
    for (const JsonValue& entity : entity_values(document))
        if (entity.find("camera") || entity.find("gltf")) names.push_back(text_member(entity, "name"));
    if (std::find(names.begin(), names.end(), camera->value.string) != names.end()) return;
    const Problems::Step step(problems, "render");
    const Problems::Step inner(problems, "camera");
    problems.add(camera->value.begin, "no camera is named '" + camera->value.string + "'",
                 "the name of an entity with a camera", nearest_name(camera->value.string, names));
}

/// Lights from far away shine everywhere: a probe that lights a box alone cannot be turned into them.
void check_probe_lights(const JsonMember& component, Problems& problems) {
    if (component.key != "light_probe") return;
    const JsonMember* extent = component.value.find("extent_m");
    const JsonMember* lights = component.value.find("lights");
    const JsonMember* count = lights ? lights->value.find("count") : nullptr;
    const auto is_some = [](const JsonValue& value) { return value.is(Kind::number) && value.number != 0.0; };
    if (!extent || !count || !is_some(count->value) || std::ranges::none_of(extent->value.items, is_some)) return;
    const Problems::Step step(problems, "lights");
    problems.add(lights->key_begin, "a light probe with a box gives no lights",
                 "a probe without extent_m, or no lights");
}

class Validation {
 public:
    Validation(const JsonDocument& document, const ComponentRegistry& registry, const Settings& settings,
               std::span<const std::string> loaded)
        : document_(document),
          registry_(registry),
          settings_(settings),
          missing_(missing_modules(document, registry, settings, loaded)),
          problems_(document, list_) {}

    std::vector<Diagnostic> run() {
        if (const JsonMember* render = document_.root.find("render")) {
            const Problems::Step step(problems_, "render");
            for (const JsonMember& member : render->value.members) check_settings(member);
        }
        check_camera(document_, problems_);
        const Problems::Step step(problems_, "entities");
        const std::vector<JsonValue>& entities = entity_values(document_);
        for (size_t i = 0; i < entities.size(); ++i) {
            const Problems::Step item(problems_, i);
            for (const JsonMember& member : entities[i].members) check_component(member);
        }
        return std::move(list_);
    }

 private:
    void check_settings(const JsonMember& member) {
        if (std::ranges::find(kRenderKeys, member.key) != std::end(kRenderKeys)) return;
        const Problems::Step step(problems_, member.key);
        const StructType* type = settings_.type(member.key);
        if (type) {
            StructObject scratch(*type);
            read_component(*type, scratch.get(), member.value, problems_);
        } else if (missing_.empty()) {
            std::vector<std::string> names = settings_.names();
            names.insert(names.end(), std::begin(kRenderKeys), std::end(kRenderKeys));
            problems_.add(member.key_begin, "unknown setting '" + member.key + "'", join_names(names),
                          nearest_name(member.key, names));
        }
    }

    void check_component(const JsonMember& member) {
        if (std::ranges::find(kEntityKeys, member.key) != std::end(kEntityKeys)) return;
        const Problems::Step step(problems_, member.key);
        const ComponentId id = registry_.find(member.key);
        if (!is_authored(member.key)) {
            problems_.add(member.key_begin, "component '" + member.key + "' is made by the engine",
                          "one that can be written");
        } else if (id != ComponentId::none) {
            StructObject scratch(registry_.type(id));
            read_component(registry_.type(id), scratch.get(), member.value, problems_);
            check_probe_lights(member, problems_);
        } else if (missing_.empty()) {
            std::vector<std::string> names = registry_.names();
            std::erase_if(names, [](const std::string& name) { return !is_authored(name); });
            names.insert(names.end(), std::begin(kEntityKeys), std::end(kEntityKeys));
            problems_.add(member.key_begin, "unknown component '" + member.key + "'",
                          "a component, \"name\" or \"parent\"", nearest_name(member.key, names));
        }
    }

    const JsonDocument& document_;
    const ComponentRegistry& registry_;
    const Settings& settings_;
    std::vector<std::string> missing_;
    std::vector<Diagnostic> list_;
    Problems problems_;
};

}  // namespace

std::vector<std::string> missing_modules(const JsonDocument& document, const ComponentRegistry& registry,
                                         const Settings& settings, std::span<const std::string> loaded) {
    std::vector<std::string> missing;
    const JsonMember* modules = document.root.find("modules");
    if (!modules) return missing;
    for (const JsonValue& module : modules->value.items) {
        const auto owns_component = [&](ComponentId id) { return registry.owner(id) == module.string; };
        const auto owns_settings = [&](const std::string& name) { return settings.owner(name) == module.string; };
        if (std::ranges::find(loaded, module.string) == loaded.end() &&
            std::ranges::none_of(registry.ids(), owns_component) &&
            std::ranges::none_of(settings.names(), owns_settings))
            missing.push_back(module.string);
    }
    return missing;
}

std::vector<Diagnostic> validate_scene(const JsonDocument& document, const ComponentRegistry& registry,
                                       const Settings& settings, std::span<const std::string> loaded) {
    return Validation(document, registry, settings, loaded).run();
}

void read_render(const JsonDocument& document, Settings& settings, RenderOptions& options) {
    const JsonMember* render = document.root.find("render");
    if (!render) return;
    std::vector<Diagnostic> list;
    Problems problems(document, list);
    for (const JsonMember& member : render->value.members) {
        if (const StructType* type = settings.type(member.key))
            read_component(*type, settings.find(member.key), member.value, problems);
    }
    const auto read = [&](std::string_view key, std::string& option) {
        const JsonMember* member = render->value.find(key);
        if (member && member->value.is(Kind::string)) option = member->value.string;
    };
    read("path", options.path);
    read("display", options.display);
    read("view", options.view);
    read("camera", options.camera);
}

}  // namespace tyndall
