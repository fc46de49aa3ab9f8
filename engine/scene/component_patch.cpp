#include <cmath>

#include "scene/component_form.h"
#include "scene/field_writer.h"

namespace tyndall {
namespace {

using Kind = JsonValue::Kind;

void patch_struct(TextPatch& patch, const StructType& type, const void* base, const void* now, const JsonValue& json,
                  std::string_view skip = {});

void patch_numbers(TextPatch& patch, const Field& field, const void* base, const void* now, const JsonValue& json) {
    const size_t count = float_count(field.kind);
    if (!json.is(Kind::array) || json.items.size() != count) return patch.replace(json, write_field(field, now));
    for (size_t i = 0; i < count; ++i) {
        const float number = static_cast<const float*>(now)[i];
        if (number != static_cast<const float*>(base)[i]) patch.replace(json.items[i], json_number(number));
    }
}

void patch_field(TextPatch& patch, const Field& field, const void* base, const void* now, const JsonValue& json) {
    if (field_equal(field, base, now)) return;
    void* const from = const_cast<void*>(base);
    void* const to = const_cast<void*>(now);
    if (float_count(field.kind) > 1) return patch_numbers(patch, field, base, now, json);
    if (field.kind == FieldKind::structure && json.is(Kind::object))
        return patch_struct(patch, *field.type, base, now, json);
    if (field.kind == FieldKind::choice) {
        const size_t index = field.choice_index(now);
        const JsonMember* member = json.find(field.names[index]);
        if (member && member->value.is(Kind::object) && field.choice_index(base) == index)
            return patch_struct(patch, *field.alternatives[index], field.choice_value(from), field.choice_value(to),
                                member->value);
    }
    if (field.kind == FieldKind::list && json.is(Kind::array)) {
        const size_t size = field.list_size(now);
        if (field.list_size(base) == size && json.items.size() == size) {
            for (size_t i = 0; i < size; ++i)
                patch_field(patch, *field.element, field.list_at(from, i), field.list_at(to, i), json.items[i]);
            return;
        }
    }
    patch.replace(json, write_field(field, now));
}

std::string member_text(const Field& field, const void* base, const void* now) {
    return json_quote(field.name) + ": " + write_field_changes(field, field.in(base), field.in(now));
}

void patch_struct(TextPatch& patch, const StructType& type, const void* base, const void* now, const JsonValue& json,
                  std::string_view skip) {
    std::vector<std::string> added;
    for (const Field& field : type.fields) {
        if (field.name == skip || field_equal(field, field.in(base), field.in(now))) continue;
        if (const JsonMember* member = json.find(field.name))
            patch_field(patch, field, field.in(base), field.in(now), member->value);
        else
            added.push_back(member_text(field, base, now));
    }
    if (!added.empty()) patch.change_members(json, {}, added);
}

/// A "look_at" stays unless the rotation is another than the one it gives; a single "scale" stays single.
void patch_transform(TextPatch& patch, const StructType& type, const Transform& base, const Transform& now,
                     const JsonValue& json) {
    Transform target = now;
    const JsonMember* scale = json.find("scale");
    const bool uniform =
        scale && scale->value.is(Kind::number) && now.scale.x == now.scale.y && now.scale.x == now.scale.z;
    if (uniform) {
        if (now.scale.x != base.scale.x) patch.replace(scale->value, json_number(now.scale.x));
        target.scale = base.scale;
    }
    const JsonMember* look_at = json.find("look_at");
    if (!look_at) return patch_struct(patch, type, &base, &target, json);

    const bool turned = 1.0f - std::abs(glm::dot(base.rotation, now.rotation)) > 1e-6f;
    if (!turned) return patch_struct(patch, type, &base, &target, json, "rotation");
    std::vector<bool> removed(json.members.size());
    removed[static_cast<size_t>(look_at - json.members.data())] = true;
    std::vector<std::string> added;
    for (const Field& field : type.fields) {
        const JsonMember* member = json.find(field.name);
        if (field.name == "rotation")
            added.push_back(json_quote(field.name) + ": " + write_field(field, field.in(&target)));
        else if (member)
            patch_field(patch, field, field.in(&base), field.in(&target), member->value);
        else if (!field_equal(field, field.in(&base), field.in(&target)))
            added.push_back(member_text(field, &base, &target));
    }
    patch.change_members(json, removed, added);
}

}  // namespace

void patch_component(TextPatch& patch, const StructType& type, const void* base, const void* now,
                     const JsonValue& json) {
    if (!json.is(Kind::object)) return;
    if (type.name == Transform::kName)
        patch_transform(patch, type, *static_cast<const Transform*>(base), *static_cast<const Transform*>(now), json);
    else
        patch_struct(patch, type, base, now, json);
}

}  // namespace tyndall
