#include <algorithm>
#include <iterator>
#include <unordered_map>

#include "scene/component_form.h"
#include "scene/field_writer.h"
#include "scene/scene_file_state.h"
#include "scene/scene_structure.h"
#include "scene/struct_object.h"

namespace tyndall {
namespace {

std::string member(std::string_view key, const std::string& json) {
    return json_quote(key) + ": " + json;
}

/// What a text says of a component, read as loading it would.
class TextValue {
 public:
    TextValue(const StructType& type, const JsonDocument& document, const JsonValue& json) : object_(type) {
        std::vector<Diagnostic> ignored;
        Problems problems(document, ignored);
        form_ = read_component(type, object_.get(), json, problems);
    }
    [[nodiscard]] void* get() { return object_.get(); }
    [[nodiscard]] const ComponentForm& form() const { return form_; }

 private:
    StructObject object_;
    ComponentForm form_;
};

class Update {
 public:
    Update(const SceneFile::Implementation& state, const World& world)
        : state_(state), world_(world), patch_(state.document) {
        for (const Entity entity : world.entities()) {
            if (!is_saved(entity)) continue;
            saved_.push_back(entity);
            if (!world.name(entity).empty()) ++name_count_[world.name(entity)];
        }
    }

    UpdatedScene run(const Settings& settings, const RenderOptions& options) {
        update_entities();
        update_render(settings, options);
        if (!top_level_added_.empty()) patch_.change_members(state_.document.root, {}, top_level_added_);
        result_.text = patch_.empty() ? state_.document.text : patch_.apply();
        return std::move(result_);
    }

 private:
    [[nodiscard]] bool is_saved(Entity entity) const {
        const ComponentId transient = world_.registry().find("transient");
        for (Entity at = entity; at; at = world_.parent(at))
            if (world_.find(at, transient)) return false;
        return true;
    }

    [[nodiscard]] bool is_camera(const std::string& name) const {
        const Entity entity = world_.find_named(name);
        const auto has = [&](std::string_view component) {
            return world_.find(entity, world_.registry().find(component)) != nullptr;
        };
        return !name.empty() && entity && is_saved(entity) && (has("camera") || has("gltf"));
    }

    void update_entities() {
        const std::vector<JsonValue>& values = entity_values(state_.document);
        std::vector<bool> removed(values.size());
        for (size_t i = 0; i < values.size(); ++i) {
            const Entity entity = state_.entities[i];
            removed[i] = !world_.alive(entity) || !is_saved(entity);
            if (removed[i]) continue;
            for (const JsonMember& m : values[i].members)
                if (state_.verbatim.contains({i, m.key})) result_.verbatim.emplace(result_.entities.size(), m.key);
            result_.entities.push_back(entity);
            update_entity(i, entity, values[i]);
        }
        std::vector<std::string> added;
        for (const Entity entity : saved_) {
            if (std::ranges::find(state_.entities, entity) != state_.entities.end()) continue;
            added.push_back(write_entity(entity));
            result_.entities.push_back(entity);
        }
        if (const JsonMember* entities = state_.document.root.find("entities"))
            patch_.change_members(entities->value, removed, added);
        else if (!added.empty())
            top_level_added_.push_back(member("entities", "[" + join(added) + "]"));
    }

    static std::string join(const std::vector<std::string>& texts) {
        std::string out;
        for (const std::string& text : texts) out += (out.empty() ? "" : ", ") + text;
        return out;
    }

    /// The value of "parent", or empty for a root.
    [[nodiscard]] std::string parent_name(Entity entity) const {
        const Entity parent = world_.parent(entity);
        if (!parent) return {};
        const std::string& name = world_.name(parent);
        const auto count = name_count_.find(name);
        if (count == name_count_.end() || count->second != 1)
            throw Error("entity '" + world_.name(entity) + "' cannot be saved: the name '" + name +
                        "' of its parent must be one that no other entity has");
        return name;
    }

    [[nodiscard]] std::string write_entity(Entity entity) const {
        std::vector<std::string> parts;
        if (!world_.name(entity).empty()) parts.push_back(member("name", json_quote(world_.name(entity))));
        if (const std::string parent = parent_name(entity); !parent.empty())
            parts.push_back(member("parent", json_quote(parent)));
        for (const ComponentId id : world_.components(entity))
            if (is_authored(world_.registry().type(id).name)) parts.push_back(write_component(entity, id));
        return parts.empty() ? "{}" : "{ " + join(parts) + " }";
    }

    [[nodiscard]] std::string write_component(Entity entity, ComponentId id) const {
        const StructType& type = world_.registry().type(id);
        const StructObject defaults(type);
        return member(type.name, write_struct_changes(type, defaults.get(), world_.find(entity, id)));
    }

    void update_entity(size_t index, Entity entity, const JsonValue& json) {
        std::vector<bool> removed(json.members.size());
        std::vector<std::string> added;
        const auto update_text = [&](std::string_view key, const std::string& now) {
            const JsonMember* there = json.find(key);
            if (there && now.empty())
                removed[static_cast<size_t>(there - json.members.data())] = true;
            else if (there && there->value.string != now)
                patch_.replace(there->value, json_quote(now));
            else if (!there && !now.empty())
                added.push_back(member(key, json_quote(now)));
        };
        update_text("name", world_.name(entity));
        update_text("parent", parent_name(entity));
        for (size_t i = 0; i < json.members.size(); ++i) {
            const JsonMember& component = json.members[i];
            const ComponentId id = world_.registry().find(component.key);
            if (std::ranges::find(kEntityKeys, component.key) != std::end(kEntityKeys)) continue;
            if (id == ComponentId::none || state_.verbatim.contains({index, component.key})) continue;
            if (const void* now = world_.find(entity, id))
                update_component(entity, id, now, component.value);
            else
                removed[i] = true;
        }
        for (const ComponentId id : world_.components(entity)) {
            const std::string& name = world_.registry().type(id).name;
            if (is_authored(name) && !json.find(name)) added.push_back(write_component(entity, id));
        }
        patch_.change_members(json, removed, added);
    }

    void update_component(Entity entity, ComponentId id, const void* now, const JsonValue& json) {
        const StructType& type = world_.registry().type(id);
        TextValue base(type, state_.document, json);
        if (base.form().look_at) {
            // What loading would give now, since the entity or one above it may have been moved.
            const auto& moved = *static_cast<const Transform*>(now);
            static_cast<Transform*>(base.get())->rotation =
                look_at_rotation(parent_matrix(world_, entity), moved.translation, *base.form().look_at);
        }
        patch_component(patch_, type, base.get(), now, json);
    }

    void update_render(const Settings& settings, const RenderOptions& options) {
        const JsonMember* render = state_.document.root.find("render");
        std::vector<std::string> added;
        const RenderOptions defaults;
        const auto update_text = [&](std::string_view key, const std::string& now, const std::string& fallback) {
            const JsonMember* there = render ? render->value.find(key) : nullptr;
            if (there && there->value.string != now)
                patch_.replace(there->value, json_quote(now));
            else if (!there && now != fallback)
                added.push_back(member(key, json_quote(now)));
        };
        update_text("path", options.path, defaults.path);
        update_text("display", options.display, defaults.display);
        update_text("view", options.view, defaults.view);
        // A camera that is gone is not asked for: the file would not load.
        update_text("camera", is_camera(options.camera) ? options.camera : "", defaults.camera);
        for (const std::string& name : settings.names()) {
            const StructType& type = *settings.type(name);
            const void* now = settings.find(name);
            if (const JsonMember* there = render ? render->value.find(name) : nullptr) {
                TextValue base(type, state_.document, there->value);
                patch_component(patch_, type, base.get(), now, there->value);
            } else if (const StructObject base(type); !struct_equal(type, base.get(), now)) {
                added.push_back(member(name, write_struct_changes(type, base.get(), now)));
            }
        }
        if (render)
            patch_.change_members(render->value, {}, added);
        else if (!added.empty())
            top_level_added_.push_back(member("render", "{ " + join(added) + " }"));
    }

    const SceneFile::Implementation& state_;
    const World& world_;
    TextPatch patch_;
    std::vector<Entity> saved_;
    std::unordered_map<std::string, size_t> name_count_;
    std::vector<std::string> top_level_added_;
    UpdatedScene result_;
};

}  // namespace

UpdatedScene update_scene(const SceneFile::Implementation& state, const World& world, const Settings& settings,
                          const RenderOptions& options) {
    return Update(state, world).run(settings, options);
}

}  // namespace tyndall
