#include "scene/component_form.h"
#include "scene/field_writer.h"
#include "scene/scene_file.h"
#include "scene/text_patch.h"

namespace tyndall {
namespace {

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

}  // namespace tyndall
