#include "scene/scene_structure.h"

#include <algorithm>
#include <iterator>
#include <unordered_map>
#include <unordered_set>

#include "scene/field_reader.h"

namespace tyndall {
namespace {

using Kind = JsonValue::Kind;

constexpr int kVersion = 1;

void check_duplicates(const JsonValue& value, Problems& problems) {
    std::unordered_set<std::string_view> seen;
    for (const JsonMember& member : value.members) {
        const Problems::Step step(problems, member.key);
        if (!seen.insert(member.key).second)
            problems.add(member.key_begin, "key '" + member.key + "' is there twice", "it once");
        check_duplicates(member.value, problems);
    }
    for (size_t i = 0; i < value.items.size(); ++i) {
        if (value.items[i].items.empty() && value.items[i].members.empty()) continue;
        const Problems::Step step(problems, i);
        check_duplicates(value.items[i], problems);
    }
}

void check_top_level(const JsonValue& root, Problems& problems) {
    static const std::vector<std::string> kKeys = {"$schema", "description", "tyndall",
                                                   "modules", "render",      "entities"};
    for (const JsonMember& member : root.members) {
        const Problems::Step step(problems, member.key);
        if (std::find(kKeys.begin(), kKeys.end(), member.key) == kKeys.end())
            problems.add(member.key_begin, "unknown key '" + member.key + "'", join_names(kKeys),
                         nearest_name(member.key, kKeys));
        else if ((member.key == "$schema" || member.key == "description") && !member.value.is(Kind::string))
            problems.wrong_kind(member.value, "a string");
    }
    const JsonMember* version = root.find("tyndall");
    if (!version) return problems.add(root.begin, "has no version", "\"tyndall\": 1");
    const Problems::Step step(problems, "tyndall");
    if (!version->value.is(Kind::number))
        problems.wrong_kind(version->value, "the version 1");
    else if (version->value.number != kVersion)
        problems.add(version->value.begin, "is of another version", "the version 1");
}

void check_modules(const JsonValue& root, Problems& problems) {
    const JsonMember* modules = root.find("modules");
    if (!modules) return;
    const Problems::Step step(problems, "modules");
    if (!modules->value.is(Kind::array)) return problems.wrong_kind(modules->value, "an array of module names");
    for (size_t i = 0; i < modules->value.items.size(); ++i) {
        const JsonValue& name = modules->value.items[i];
        const Problems::Step item(problems, i);
        constexpr std::string_view kLetters = "abcdefghijklmnopqrstuvwxyz0123456789_";
        if (!name.is(Kind::string))
            problems.wrong_kind(name, "the name of a module");
        else if (name.string.empty() || name.string.find_first_not_of(kLetters) != std::string::npos)
            problems.add(name.begin, "'" + name.string + "' is no module name", "lower case letters, digits and _");
    }
}

void check_render(const JsonValue& root, Problems& problems) {
    const JsonMember* render = root.find("render");
    if (!render) return;
    const Problems::Step step(problems, "render");
    if (!render->value.is(Kind::object)) return problems.wrong_kind(render->value, "an object");
    for (const std::string_view key : kRenderKeys) {
        const JsonMember* member = render->value.find(key);
        if (!member) continue;
        const Problems::Step inner(problems, key);
        static const std::vector<std::string> kPaths = {"deferred", "light_pre_pass"};
        const std::string& text = member->value.string;
        if (!member->value.is(Kind::string))
            problems.wrong_kind(member->value, "a string");
        else if (key == "path" && std::find(kPaths.begin(), kPaths.end(), text) == kPaths.end())
            problems.add(member->value.begin, "unknown path '" + text + "'", join_names(kPaths),
                         nearest_name(text, kPaths));
    }
}

void check_entity(const JsonValue& entity, Problems& problems) {
    if (!entity.is(Kind::object)) return problems.wrong_kind(entity, "an object");
    for (const JsonMember& member : entity.members) {
        const Problems::Step step(problems, member.key);
        const bool own = std::ranges::find(kEntityKeys, member.key) != std::end(kEntityKeys);
        if (own && !member.value.is(Kind::string)) problems.wrong_kind(member.value, "a string");
        if (!own && !member.value.is(Kind::object)) problems.wrong_kind(member.value, "an object");
    }
}

/// Parents by name: each must exist, once, and no entity may be above itself.
class Parents {
 public:
    Parents(const std::vector<JsonValue>& entities, Problems& problems) : entities_(entities), problems_(problems) {
        for (size_t i = 0; i < entities.size(); ++i) {
            const std::string name = text_member(entities[i], "name");
            if (!name.empty()) named_[name].push_back(i);
        }
    }

    void check() {
        for (size_t i = 0; i < entities_.size(); ++i) {
            const JsonMember* parent = entities_[i].find("parent");
            if (!parent || !parent->value.is(Kind::string)) continue;
            const Problems::Step step(problems_, i);
            const Problems::Step inner(problems_, "parent");
            check_one(i, parent->value);
        }
    }

 private:
    void check_one(size_t i, const JsonValue& parent) {
        const auto found = named_.find(parent.string);
        if (found == named_.end()) {
            std::vector<std::string> names;
            for (const auto& [name, where] : named_) names.push_back(name);
            std::sort(names.begin(), names.end());
            problems_.add(parent.begin, "no entity is named '" + parent.string + "'", "the name of another entity",
                          nearest_name(parent.string, names));
        } else if (found->second.size() > 1) {
            problems_.add(parent.begin,
                          std::to_string(found->second.size()) + " entities are named '" + parent.string + "'",
                          "a name that only one entity has");
        } else if (is_above_itself(i)) {
            problems_.add(parent.begin, "the entity is its own ancestor", "a parent that is not below it");
        }
    }

    bool is_above_itself(size_t start) {
        size_t at = start;
        for (size_t steps = 0; steps <= entities_.size(); ++steps) {
            const auto found = named_.find(text_member(entities_[at], "parent"));
            if (found == named_.end()) return false;
            at = found->second.front();
            if (at == start) return true;
        }
        return false;  // a cycle further up, which its own members report
    }

    const std::vector<JsonValue>& entities_;
    Problems& problems_;
    std::unordered_map<std::string, std::vector<size_t>> named_;
};

void check_entities(const JsonValue& root, Problems& problems) {
    const JsonMember* entities = root.find("entities");
    if (!entities) return;
    const Problems::Step step(problems, "entities");
    if (!entities->value.is(Kind::array)) return problems.wrong_kind(entities->value, "an array of entities");
    for (size_t i = 0; i < entities->value.items.size(); ++i) {
        const Problems::Step item(problems, i);
        check_entity(entities->value.items[i], problems);
    }
    Parents(entities->value.items, problems).check();
}

}  // namespace

const std::vector<JsonValue>& entity_values(const JsonDocument& document) {
    static const std::vector<JsonValue> kNone;
    const JsonMember* entities = document.root.find("entities");
    return entities ? entities->value.items : kNone;
}

std::string text_member(const JsonValue& object, std::string_view key) {
    const JsonMember* member = object.find(key);
    return member ? member->value.string : std::string{};
}

void check_structure(Problems& problems) {
    const JsonValue& root = problems.document().root;
    if (!root.is(Kind::object)) return problems.wrong_kind(root, "an object: a scene");
    check_duplicates(root, problems);
    check_top_level(root, problems);
    check_modules(root, problems);
    check_render(root, problems);
    check_entities(root, problems);
}

}  // namespace tyndall
