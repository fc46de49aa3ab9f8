#include <algorithm>

#include "scene/component_form.h"
#include "scene/field_writer.h"
#include "scene/scene_file.h"
#include "scene/struct_object.h"

namespace tyndall {
namespace {

std::string kind_text(const Field& field) {
    switch (field.kind) {
        case FieldKind::boolean:
            return "true or false";
        case FieldKind::integer:
            return "whole number";
        case FieldKind::real:
            return "number";
        case FieldKind::vec2:
            return "[x, y]";
        case FieldKind::vec3:
            return field.colour ? "[r, g, b]" : "[x, y, z]";
        case FieldKind::vec4:
            return "[x, y, z, w]";
        case FieldKind::quaternion:
            return "[x, y, z, w]";
        case FieldKind::text:
            return field.asset.empty() ? "text" : field.asset + " file";
        case FieldKind::enumeration:
        case FieldKind::choice: {
            std::string text = field.kind == FieldKind::choice ? "one of " : "";
            for (const std::string& name : field.names)
                text += (text.size() > 7 || &name != &field.names[0] ? ", `" : "`") + name + "`";
            return text;
        }
        case FieldKind::structure:
            return "object";
        case FieldKind::list:
            return "list of " + kind_text(*field.element);
    }
    return {};
}

/// Bars would end a table's cell.
std::string cell(std::string text) {
    for (size_t at = 0; (at = text.find('|', at)) != std::string::npos; at += 2) text.insert(at, "\\");
    return text;
}

void write_rows(std::string& out, const StructType& type, const void* defaults, const std::string& prefix) {
    for (const Field& field : type.fields) {
        const void* at = field.in(defaults);
        const std::string name = prefix + field.name;
        const bool nested = field.kind == FieldKind::structure;
        const std::string range =
            field.kind == FieldKind::integer && field.minimum < -2147483648.0 ? "" : range_text(field);
        out += "| `" + name + "` | " + cell(kind_text(field)) + " | " +
               (nested ? "" : "`" + cell(write_field(field, at)) + "`") + " | " + field.unit + " | " + range + " | " +
               cell(field.doc) + " |\n";
        if (nested) write_rows(out, *field.type, at, name + ".");
        if (field.kind == FieldKind::list && field.element->kind == FieldKind::structure) {
            const StructObject element(*field.element->type);
            write_rows(out, *field.element->type, element.get(), name + "[].");
        }
        for (size_t i = 0; i < field.alternatives.size(); ++i) {
            const StructObject alternative(*field.alternatives[i]);
            write_rows(out, *field.alternatives[i], alternative.get(), name + "." + field.names[i] + ".");
        }
    }
}

void write_section(std::string& out, const StructType& type, const std::string& owner) {
    out += "### " + type.name + "\n\n";
    if (owner != "engine") out += "From the module `" + owner + "`. ";
    out += type.doc + "\n\n";
    if (const std::vector<std::string> presets = preset_names(type.name); !presets.empty())
        out += "Presets (`\"preset\": \"NAME\"`): " + join_names(presets) + ".\n\n";
    if (type.fields.empty()) {
        out += "No fields: `{}`.\n\n";
        return;
    }
    const StructObject defaults(type);
    out += "| field | kind | default | unit | range | |\n|---|---|---|---|---|---|\n";
    write_rows(out, type, defaults.get(), {});
    if (type.name == Transform::kName)
        out += "| `look_at` | [x, y, z] | | m | | A point in the world that local -Z faces; instead of `rotation`. |\n";
    out += "\n";
}

}  // namespace

std::string component_manual(const ComponentRegistry& registry, const Settings& settings) {
    std::string out =
        "# Components and settings\n\nMade by `tyndall schema --manual` from the descriptions in the code.\n\n";
    out += "## Components of entities\n\n";
    for (const ComponentId id : registry.ids())
        if (is_authored(registry.type(id).name)) write_section(out, registry.type(id), registry.owner(id));
    const std::vector<std::string> names = settings.names();
    if (!names.empty()) out += "## Settings in \"render\"\n\n";
    for (const std::string& name : names) write_section(out, *settings.type(name), settings.owner(name));
    out.pop_back();
    return out;
}

}  // namespace tyndall
