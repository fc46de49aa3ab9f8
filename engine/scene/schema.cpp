#include <cmath>
#include <nlohmann/json.hpp>

#include "scene/component_form.h"
#include "scene/field_writer.h"
#include "scene/scene_file.h"
#include "scene/scene_structure.h"
#include "scene/struct_object.h"

namespace tyndall {
namespace {

using Json = nlohmann::ordered_json;

Json struct_schema(const StructType& type, const void* defaults);

std::string describe_text(const Field& field) {
    const std::string range = range_text(field);
    std::string text = field.doc;
    if (!field.unit.empty()) text += " Unit: " + field.unit + ".";
    if (field.kind != FieldKind::integer && !range.empty()) text += " Range: " + range + ".";
    return text;
}

void add_range(Json& schema, const Field& field) {
    const auto exact = [](double value) { return Json::parse(json_number(static_cast<float>(value))); };
    if (std::isfinite(field.minimum)) schema["minimum"] = exact(field.minimum);
    if (std::isfinite(field.maximum)) schema["maximum"] = exact(field.maximum);
}

Json vector_schema(const Field& field) {
    Json number = {{"type", "number"}};
    add_range(number, field);
    const size_t count = float_count(field.kind);
    return {{"type", "array"}, {"items", number}, {"minItems", count}, {"maxItems", count}};
}

Json choice_schema(const Field& field) {
    Json properties = Json::object();
    for (size_t i = 0; i < field.names.size(); ++i) {
        const StructObject defaults(*field.alternatives[i]);
        properties[field.names[i]] = struct_schema(*field.alternatives[i], defaults.get());
    }
    return {{"type", "object"},
            {"properties", properties},
            {"additionalProperties", false},
            {"minProperties", 1},
            {"maxProperties", 1}};
}

/// `at` is a field with its default.
Json field_schema(const Field& field, const void* at) {
    Json schema;
    switch (field.kind) {
        case FieldKind::boolean:
            schema["type"] = "boolean";
            break;
        case FieldKind::integer:
            schema["type"] = "integer";
            add_range(schema, field);
            break;
        case FieldKind::real:
            schema["type"] = "number";
            add_range(schema, field);
            break;
        case FieldKind::text:
            schema["type"] = "string";
            break;
        case FieldKind::enumeration:
            schema["enum"] = field.names;
            break;
        case FieldKind::structure:
            schema = struct_schema(*field.type, at);
            break;
        case FieldKind::choice:
            schema = choice_schema(field);
            break;
        case FieldKind::list: {
            schema["type"] = "array";
            if (field.element->kind == FieldKind::structure) {
                const StructObject defaults(*field.element->type);
                schema["items"] = struct_schema(*field.element->type, defaults.get());
            } else {
                schema["items"] = field_schema(list_element(field), nullptr);
            }
            break;
        }
        default:
            schema = vector_schema(field);
    }
    if (!field.doc.empty()) schema["description"] = describe_text(field);
    if (at) schema["default"] = Json::parse(write_field(field, at));
    return schema;
}

Json struct_schema(const StructType& type, const void* defaults) {
    Json properties = Json::object();
    for (const Field& field : type.fields) properties[field.name] = field_schema(field, field.in(defaults));
    Json schema = {{"type", "object"}, {"properties", properties}, {"additionalProperties", false}};
    if (!type.doc.empty()) schema["description"] = type.doc;
    return schema;
}

/// A component or settings with the keys that are no fields.
Json component_schema(const StructType& type) {
    const StructObject defaults(type);
    Json schema = struct_schema(type, defaults.get());
    Json& properties = schema["properties"];
    if (const std::vector<std::string> presets = preset_names(type.name); !presets.empty())
        properties[kPresetKey] = {{"enum", presets},
                                  {"description", "Fields from config/presets/; those given here override it."}};
    if (type.name == Transform::kName) {
        Json scale = {{"anyOf", {properties["scale"], Json{{"type", "number"}}}}};
        properties["scale"] = scale;
        properties["look_at"] = {
            {"type", "array"},
            {"items", {{"type", "number"}}},
            {"minItems", 3},
            {"maxItems", 3},
            {"description", "A point in the world, in metres, that local -Z faces; instead of rotation."}};
        schema["not"] = {{"required", {"look_at", "rotation"}}};
    }
    return schema;
}

Json text_schema(std::string_view description) {
    return {{"type", "string"}, {"description", description}};
}

Json entity_schema(const ComponentRegistry& registry) {
    Json properties = Json::object();
    properties["name"] = text_schema("What others call the entity: parents, cameras, messages.");
    properties["parent"] = text_schema("The name of the entity that this one moves with.");
    for (const ComponentId id : registry.ids()) {
        const StructType& type = registry.type(id);
        if (is_authored(type.name)) properties[type.name] = component_schema(type);
    }
    // Components of modules that are not loaded are kept, so any object may stand there.
    return {{"type", "object"}, {"properties", properties}, {"additionalProperties", {{"type", "object"}}}};
}

Json render_schema(const Settings& settings) {
    Json properties = Json::object();
    properties["path"] = {{"enum", {"deferred", "light_pre_pass"}},
                          {"default", "deferred"},
                          {"description", "How surfaces are lit; both give the same picture."}};
    properties["display"] = text_schema("OpenColorIO display; the configuration's default when absent.");
    properties["view"] = text_schema("OpenColorIO view; the display's default when absent.");
    properties["camera"] = text_schema("The entity whose camera is used; the first when absent.");
    for (const std::string& name : settings.names()) properties[name] = component_schema(*settings.type(name));
    return {{"type", "object"}, {"properties", properties}, {"additionalProperties", {{"type", "object"}}}};
}

}  // namespace

std::string scene_schema(const ComponentRegistry& registry, const Settings& settings) {
    Json properties = Json::object();
    properties["$schema"] = {{"type", "string"}};
    properties["description"] = text_schema("What the scene shows, for people.");
    properties["tyndall"] = {{"const", 1}, {"description", "The version of the format."}};
    properties["modules"] = {{"type", "array"},
                             {"items", {{"type", "string"}, {"pattern", "^[a-z0-9_]+$"}}},
                             {"description", "Modules that the scene needs."}};
    properties["render"] = render_schema(settings);
    properties["entities"] = {{"type", "array"}, {"items", entity_schema(registry)}};
    const Json schema = {{"$schema", "https://json-schema.org/draft/2020-12/schema"},
                         {"title", "Tyndall scene"},
                         {"type", "object"},
                         {"required", {"tyndall"}},
                         {"properties", properties},
                         {"additionalProperties", false}};
    return schema.dump(2) + "\n";
}

}  // namespace tyndall
