#include "scene/component_form.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <glm/gtc/matrix_inverse.hpp>

#include "core/paths.h"

namespace tyndall {
namespace fs = std::filesystem;
namespace {

using Kind = JsonValue::Kind;

fs::path preset_folder(std::string_view component) {
    return paths::root() / "config" / "presets" / component;
}

/// Whether "preset" means a preset here and is no field of the type's own.
bool takes_preset(const StructType& type) {
    return !type.find(kPresetKey);
}

/// Takes the members out that the plain reader must not see.
JsonValue without(const JsonValue& object, std::initializer_list<std::string_view> keys) {
    JsonValue rest = object;
    std::erase_if(rest.members, [&](const JsonMember& m) { return std::ranges::find(keys, m.key) != keys.end(); });
    return rest;
}

void apply_preset(const StructType& type, void* object, const JsonMember& member, Problems& problems) {
    const Problems::Step step(problems, kPresetKey);
    const JsonValue& value = member.value;
    const std::vector<std::string> names = preset_names(type.name);
    if (!value.is(Kind::string)) return problems.wrong_kind(value, "the name of a preset");
    if (std::find(names.begin(), names.end(), value.string) == names.end())
        return problems.add(value.begin, "unknown preset '" + value.string + "'",
                            names.empty() ? "no preset: " + type.name + " has none" : join_names(names),
                            nearest_name(value.string, names));
    const fs::path file = preset_folder(type.name) / (value.string + ".json");
    try {
        const JsonDocument document = parse_json(paths::read_file(file), file.string());
        Problems in_preset(document, problems.list());
        read_struct(type, object, without(document.root, {kDocKey}), in_preset);
    } catch (const Error& error) {
        for (const Diagnostic& diagnostic : error.diagnostics()) problems.list().push_back(diagnostic);
    }
}

const Field& look_at_field() {
    static const Field field = [] {
        Field made;
        made.kind = FieldKind::vec3;
        return made;
    }();
    return field;
}

/// Reads what a transform has beside its plain fields, and takes it out of `json`.
ComponentForm read_transform_form(const StructType& type, Transform& transform, JsonValue& json, Problems& problems) {
    ComponentForm form;
    const JsonMember* target = json.find("look_at");
    if (target) {
        const Problems::Step step(problems, "look_at");
        const size_t before = problems.list().size();
        glm::vec3 point{0.0f};
        read_field(look_at_field(), &point, target->value, problems);
        if (problems.list().size() == before) form.look_at = point;
        if (json.find("rotation"))
            problems.add(target->key_begin, "look_at and rotation say the same thing", "one of them");
    }
    const JsonMember* scale = json.find("scale");
    const bool uniform = scale && scale->value.is(Kind::number);
    if (uniform) {
        const Problems::Step step(problems, "scale");
        float factor = 1.0f;
        if (read_real(*type.find("scale"), factor, scale->value, problems)) transform.scale = glm::vec3(factor);
    }
    json = uniform ? without(json, {"look_at", "scale"}) : without(json, {"look_at"});
    return form;
}

}  // namespace

std::vector<std::string> preset_names(std::string_view component) {
    std::vector<std::string> names;
    std::error_code none;
    for (const auto& entry : fs::directory_iterator(preset_folder(component), none))
        if (entry.path().extension() == ".json") names.push_back(entry.path().stem().string());
    std::sort(names.begin(), names.end());
    return names;
}

bool is_authored(std::string_view component) {
    constexpr std::array<std::string_view, 2> kMade = {WorldMatrix::kName, "transient"};
    return std::find(kMade.begin(), kMade.end(), component) == kMade.end();
}

ComponentForm read_component(const StructType& type, void* object, const JsonValue& json, Problems& problems,
                             std::string* unknown) {
    ComponentForm form;
    const UnknownFields policy = unknown ? UnknownFields::keep : UnknownFields::report;
    const bool transform = type.name == Transform::kName;
    const JsonMember* preset = takes_preset(type) ? json.find(kPresetKey) : nullptr;
    std::string left;
    if (!preset && !transform) {
        left = read_struct(type, object, json, problems, policy);
    } else {
        if (preset) apply_preset(type, object, *preset, problems);
        JsonValue rest = preset ? without(json, {kPresetKey}) : json;
        if (transform) form = read_transform_form(type, *static_cast<Transform*>(object), rest, problems);
        left = read_struct(type, object, rest, problems, policy);
    }
    if (unknown) *unknown = std::move(left);
    return form;
}

glm::quat look_at_rotation(const glm::mat4& parent, const glm::vec3& translation, const glm::vec3& target) {
    const glm::quat identity(1.0f, 0.0f, 0.0f, 0.0f);
    const float volume = glm::determinant(parent);
    if (!(std::abs(volume) > 1e-20f)) return identity;
    const glm::mat4 to_parent = glm::affineInverse(parent);
    const glm::vec3 offset = glm::vec3(to_parent * glm::vec4(target, 1.0f)) - translation;
    const float distance = glm::length(offset);
    if (!(distance > 1e-9f) || !std::isfinite(distance)) return identity;
    const glm::vec3 back = -offset / distance;
    const glm::vec3 up = glm::normalize(glm::mat3(to_parent) * glm::vec3(0.0f, 1.0f, 0.0f));
    glm::vec3 right = glm::cross(up, back);
    // Straight up or down there is no upright answer: keep +X to the right.
    if (glm::dot(right, right) < 1e-10f) right = glm::cross(glm::vec3(0.0f, 0.0f, back.y > 0.0f ? -1.0f : 1.0f), back);
    if (glm::dot(right, right) < 1e-10f) right = glm::cross(glm::vec3(1.0f, 0.0f, 0.0f), back);
    right = glm::normalize(right);
    return glm::normalize(glm::quat_cast(glm::mat3(right, glm::cross(back, right), back)));
}

glm::mat4 parent_matrix(const World& world, Entity entity) {
    glm::mat4 matrix(1.0f);
    for (Entity at = world.parent(entity); at; at = world.parent(at))
        if (const auto* transform = world.find<Transform>(at)) matrix = transform->matrix() * matrix;
    return matrix;
}

}  // namespace tyndall
