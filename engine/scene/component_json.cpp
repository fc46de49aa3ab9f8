#include "scene/component_form.h"
#include "scene/field_writer.h"
#include "scene/scene_file.h"
#include "scene/text_patch.h"

namespace tyndall {
namespace {

std::string merge_objects(const JsonDocument& base_text, const JsonValue& base, const JsonDocument& extra_text,
                          const JsonValue& extra) {
    std::string out;
    const auto put = [&](std::string_view key, std::string_view json) {
        out += (out.empty() ? "{ " : ", ") + json_quote(key) + ": " + std::string(json);
    };
    for (const JsonMember& member : base.members) {
        const JsonMember* other = extra.find(member.key);
        const bool both = other && member.value.is(JsonValue::Kind::object) && other->value.is(member.value.kind);
        put(member.key, both ? merge_objects(base_text, member.value, extra_text, other->value)
                             : std::string(base_text.raw(member.value)));
    }
    for (const JsonMember& member : extra.members)
        if (!base.find(member.key)) put(member.key, extra_text.raw(member.value));
    return out.empty() ? "{}" : out + " }";
}

JsonDocument parse_object(std::string_view json) {
    JsonDocument document = parse_json(json.empty() ? "{}" : std::string(json), "component");
    if (!document.root.is(JsonValue::Kind::object))
        throw Error(Diagnostic{document.locate(0), "is " + std::string(document.root.kind_name()), "an object", {}});
    return document;
}

}  // namespace

std::string component_to_json(const StructType& type, const void* component) {
    return write_struct(type, component);
}

std::string component_from_json(const StructType& type, void* component, std::string_view json,
                                std::vector<Diagnostic>& problems) {
    try {
        const JsonDocument document = parse_object(json);
        Problems collected(document, problems);
        std::string unknown;
        const ComponentForm form = read_component(type, component, document.root, collected, &unknown);
        if (form.look_at) {
            auto& transform = *static_cast<Transform*>(component);
            transform.rotation = look_at_rotation(glm::mat4(1.0f), transform.translation, *form.look_at);
        }
        return unknown;
    } catch (const Error& error) {
        problems.insert(problems.end(), error.diagnostics().begin(), error.diagnostics().end());
        return {};
    }
}

std::string merge_json(std::string_view base, std::string_view extra) {
    const JsonDocument base_document = parse_object(base);
    const JsonDocument extra_document = parse_object(extra);
    return merge_objects(base_document, base_document.root, extra_document, extra_document.root);
}

}  // namespace tyndall
