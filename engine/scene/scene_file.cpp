#include "scene/scene_file.h"

#include <algorithm>
#include <charconv>
#include <unordered_map>

#include "core/log.h"
#include "core/paths.h"
#include "scene/component_form.h"
#include "scene/scene_file_state.h"
#include "scene/scene_structure.h"
#include "scene/struct_object.h"

namespace tyndall {
namespace {

constexpr std::string_view kEmptyScene = "{\n  \"tyndall\": 1,\n  \"entities\": []\n}\n";

/// Reads one component of the text onto its entity; false when its type is not registered.
bool make_component(World& world, Entity entity, const JsonMember& member, Problems& problems, LookAts& look_ats) {
    const ComponentId id = world.registry().find(member.key);
    if (id == ComponentId::none) return false;
    const StructType& type = world.registry().type(id);
    StructObject value(type);
    const ComponentForm form = read_component(type, value.get(), member.value, problems);
    world.add(entity, id, value.get());
    if (form.look_at) look_ats.add(entity, *form.look_at);
    return true;
}

bool is_component(const JsonMember& member) {
    return std::ranges::find(kEntityKeys, member.key) == std::end(kEntityKeys);
}

}  // namespace

JsonDocument parse_scene(std::string text, std::string file_name) {
    JsonDocument document = parse_json(std::move(text), std::move(file_name));
    std::vector<Diagnostic> list;
    Problems problems(document, list);
    check_structure(problems);
    if (!list.empty()) throw Error(std::move(list));
    return document;
}

void LookAts::resolve(World& world) {
    // Ancestors first: a turned parent turns what its children see.
    const auto depth = [&](Entity entity) {
        size_t count = 0;
        for (Entity at = world.parent(entity); at; at = world.parent(at)) ++count;
        return count;
    };
    std::stable_sort(targets_.begin(), targets_.end(),
                     [&](const auto& a, const auto& b) { return depth(a.first) < depth(b.first); });
    for (const auto& [entity, target] : targets_) {
        auto* transform = world.find<Transform>(entity);
        transform->rotation = look_at_rotation(parent_matrix(world, entity), transform->translation, target);
    }
}

SceneFile::SceneFile() : self_(std::make_unique<Implementation>()) {
    self_->document = parse_json(std::string(kEmptyScene), {});
}
SceneFile::~SceneFile() = default;
SceneFile::SceneFile(SceneFile&&) noexcept = default;
SceneFile& SceneFile::operator=(SceneFile&&) noexcept = default;

SceneFile SceneFile::parse(std::string text, std::string file_name) {
    SceneFile scene;
    scene.self_->document = parse_scene(std::move(text), std::move(file_name));
    return scene;
}

SceneFile SceneFile::load(const std::filesystem::path& file) {
    return parse(paths::read_file(file), file.string());
}

void SceneFile::set(std::string_view pointer, std::string_view json_value) {
    std::string text = set_in_scene(self_->document, pointer, json_value);
    try {
        self_->document = parse_scene(std::move(text), self_->document.file);
    } catch (Error& error) {
        throw error.within("setting " + std::string(pointer));
    }
}

std::vector<std::string> SceneFile::modules() const {
    std::vector<std::string> names;
    if (const JsonMember* modules = self_->document.root.find("modules"))
        for (const JsonValue& name : modules->value.items) names.push_back(name.string);
    return names;
}

std::vector<Diagnostic> SceneFile::validate(const ComponentRegistry& registry, const Settings& settings,
                                            std::span<const std::string> loaded) const {
    return validate_scene(self_->document, registry, settings, loaded);
}

void SceneFile::instantiate(World& world, Settings& settings, RenderOptions& options,
                            std::span<const std::string> loaded) {
    const JsonDocument& document = self_->document;
    std::vector<Diagnostic> list = validate(world.registry(), settings, loaded);
    if (!list.empty()) throw Error(std::move(list));

    for (const std::string& module : missing_modules(document, world.registry(), settings, loaded))
        log::warning("{}: module '{}' is not loaded; what belongs to it is kept but not used", document.file, module);

    read_render(document, settings, options);
    Problems problems(document, list);
    LookAts look_ats;
    const std::vector<JsonValue>& values = entity_values(document);
    std::unordered_map<std::string, Entity> named;
    self_->entities.clear();
    self_->verbatim.clear();
    for (size_t i = 0; i < values.size(); ++i) {
        const Entity entity = world.create();
        self_->entities.push_back(entity);
        const std::string name = text_member(values[i], "name");
        if (!name.empty()) world.set_name(entity, name);
        named.emplace(name, entity);
        for (const JsonMember& member : values[i].members)
            if (is_component(member) && !make_component(world, entity, member, problems, look_ats))
                self_->verbatim.emplace(i, member.key);
    }
    for (size_t i = 0; i < values.size(); ++i)
        if (values[i].find("parent")) world.set_parent(self_->entities[i], named.at(text_member(values[i], "parent")));
    look_ats.resolve(world);
}

void SceneFile::adopt(World& world) {
    const std::vector<JsonValue>& values = entity_values(self_->document);
    std::vector<Diagnostic> list;
    Problems problems(self_->document, list);
    LookAts look_ats;
    std::erase_if(self_->verbatim, [&](const std::pair<size_t, std::string>& kept) {
        const JsonMember* member = values[kept.first].find(kept.second);
        const Entity entity = self_->entities[kept.first];
        return world.alive(entity) && make_component(world, entity, *member, problems, look_ats);
    });
    look_ats.resolve(world);
    for (const Diagnostic& diagnostic : list) log::warning("{}", diagnostic.text());
}

void SceneFile::update(const World& world, const Settings& settings, const RenderOptions& options) {
    if (self_->entities.size() != entity_values(self_->document).size())
        throw Error("the scene's entities were not made in a world: there is nothing to take changes from");
    UpdatedScene updated = update_scene(*self_, world, settings, options);
    self_->document = parse_scene(std::move(updated.text), self_->document.file);
    self_->entities = std::move(updated.entities);
    self_->verbatim = std::move(updated.verbatim);
}

const std::string& SceneFile::text() const {
    return self_->document.text;
}

void SceneFile::save(const std::filesystem::path& file) const {
    paths::write_file_atomically(file, self_->document.text);
}

SourceLocation SceneFile::location(Entity entity, std::string_view component) const {
    const auto found = std::find(self_->entities.begin(), self_->entities.end(), entity);
    if (found == self_->entities.end()) return {self_->document.file};
    const auto index = static_cast<size_t>(found - self_->entities.begin());
    const JsonValue& value = entity_values(self_->document)[index];
    const std::string pointer = "/entities/" + std::to_string(index);
    if (const JsonMember* member = value.find(component))
        return self_->document.locate(member->key_begin, pointer + pointer_token(component));
    return self_->document.locate(value.begin, pointer);
}

}  // namespace tyndall
