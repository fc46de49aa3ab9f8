#include "scene/field_writer.h"

#include <cmath>

#include "scene/field_reader.h"
#include "scene/json_text.h"
#include "scene/struct_object.h"

namespace tyndall {
namespace {

/// The description's accessors take void* although they only look.
void* mutable_pointer(const void* p) {
    return const_cast<void*>(p);
}

bool floats_equal(const float* a, const float* b, size_t count) {
    for (size_t i = 0; i < count; ++i)
        if (!(a[i] == b[i] || (std::isnan(a[i]) && std::isnan(b[i])))) return false;
    return true;
}

std::string write_floats(const float* values, size_t count) {
    std::string out = "[";
    for (size_t i = 0; i < count; ++i) out += (i > 0 ? ", " : "") + json_number(values[i]);
    return out + "]";
}

bool lists_equal(const Field& field, const void* a, const void* b) {
    const size_t size = field.list_size(a);
    if (field.list_size(b) != size) return false;
    for (size_t i = 0; i < size; ++i)
        if (!field_equal(*field.element, field.list_at(mutable_pointer(a), i), field.list_at(mutable_pointer(b), i)))
            return false;
    return true;
}

std::string write_list(const Field& field, const void* at) {
    std::string out = "[";
    for (size_t i = 0; i < field.list_size(at); ++i)
        out += (i > 0 ? ", " : "") + write_field(*field.element, field.list_at(mutable_pointer(at), i));
    return out + "]";
}

std::string one_key(const std::string& key, const std::string& json) {
    return "{ " + json_quote(key) + ": " + json + " }";
}

const StructType& alternative(const Field& choice, const void* at) {
    return *choice.alternatives[choice.choice_index(at)];
}

std::string write_members(const StructType& type, const void* base, const void* object) {
    std::string out;
    for (const Field& field : type.fields) {
        if (base && field_equal(field, field.in(base), field.in(object))) continue;
        out += out.empty() ? "{ " : ", ";
        out += json_quote(field.name) + ": ";
        out +=
            base ? write_field_changes(field, field.in(base), field.in(object)) : write_field(field, field.in(object));
    }
    return out.empty() ? "{}" : out + " }";
}

/// The object's being there switches it on, so that is what "enabled" is compared with.
std::string write_nested_changes(const StructType& type, const void* base, const void* object) {
    const Field* on = find_switch(type);
    if (!on) return write_members(type, base, object);
    StructObject switched(type, base);
    *static_cast<bool*>(on->in(switched.get())) = true;
    return write_members(type, switched.get(), object);
}

}  // namespace

bool field_equal(const Field& field, const void* a, const void* b) {
    switch (field.kind) {
        case FieldKind::boolean:
            return *static_cast<const bool*>(a) == *static_cast<const bool*>(b);
        case FieldKind::integer:
            return *static_cast<const int32_t*>(a) == *static_cast<const int32_t*>(b);
        case FieldKind::text:
            return *static_cast<const std::string*>(a) == *static_cast<const std::string*>(b);
        case FieldKind::enumeration:
            return field.get_enum(a) == field.get_enum(b);
        case FieldKind::structure:
            return struct_equal(*field.type, a, b);
        case FieldKind::list:
            return lists_equal(field, a, b);
        case FieldKind::choice:
            return field.choice_index(a) == field.choice_index(b) &&
                   struct_equal(alternative(field, a), field.choice_value(mutable_pointer(a)),
                                field.choice_value(mutable_pointer(b)));
        default:
            return floats_equal(static_cast<const float*>(a), static_cast<const float*>(b), float_count(field.kind));
    }
}

bool struct_equal(const StructType& type, const void* a, const void* b) {
    for (const Field& field : type.fields)
        if (!field_equal(field, field.in(a), field.in(b))) return false;
    return true;
}

std::string write_field(const Field& field, const void* at) {
    switch (field.kind) {
        case FieldKind::boolean:
            return *static_cast<const bool*>(at) ? "true" : "false";
        case FieldKind::integer:
            return std::to_string(*static_cast<const int32_t*>(at));
        case FieldKind::real:
            return json_number(*static_cast<const float*>(at));
        case FieldKind::text:
            return json_quote(*static_cast<const std::string*>(at));
        case FieldKind::structure:
            return write_struct(*field.type, at);
        case FieldKind::list:
            return write_list(field, at);
        case FieldKind::enumeration: {
            const auto index = static_cast<size_t>(field.get_enum(at));
            return json_quote(index < field.names.size() ? field.names[index] : field.names.front());
        }
        case FieldKind::choice:
            return one_key(field.names[field.choice_index(at)],
                           write_struct(alternative(field, at), field.choice_value(mutable_pointer(at))));
        default:
            return write_floats(static_cast<const float*>(at), float_count(field.kind));
    }
}

std::string write_struct(const StructType& type, const void* object) {
    return write_members(type, nullptr, object);
}

std::string write_field_changes(const Field& field, const void* base, const void* at) {
    if (field.kind == FieldKind::structure) return write_nested_changes(*field.type, base, at);
    if (field.kind == FieldKind::choice && field.choice_index(base) == field.choice_index(at))
        return one_key(field.names[field.choice_index(at)],
                       write_struct_changes(alternative(field, at), field.choice_value(mutable_pointer(base)),
                                            field.choice_value(mutable_pointer(at))));
    return write_field(field, at);
}

std::string write_struct_changes(const StructType& type, const void* base, const void* object) {
    return write_members(type, base, object);
}

namespace {

void wrap_value(std::string& out, const JsonDocument& document, const JsonValue& value, size_t column, size_t indent) {
    const std::string_view raw = document.raw(value);
    const bool object = value.is(JsonValue::Kind::object);
    const bool empty = value.items.empty() && value.members.empty();
    if (column + raw.size() <= kJsonColumns || empty) {
        out += raw;
        return;
    }
    const size_t inner = indent + kJsonIndent;
    const auto start_line = [&](bool first) { out += (first ? "\n" : ",\n") + std::string(inner, ' '); };
    out += object ? '{' : '[';
    for (size_t i = 0; i < value.items.size(); ++i) {
        start_line(i == 0);
        wrap_value(out, document, value.items[i], inner, inner);
    }
    for (size_t i = 0; i < value.members.size(); ++i) {
        start_line(i == 0);
        const std::string key = json_quote(value.members[i].key) + ": ";
        out += key;
        wrap_value(out, document, value.members[i].value, inner + key.size(), inner);
    }
    out += '\n' + std::string(indent, ' ') + (object ? '}' : ']');
}

}  // namespace

std::string wrap_json(const std::string& one_line, size_t column, size_t indent) {
    const JsonDocument document = parse_json(one_line, {});
    std::string out;
    wrap_value(out, document, document.root, column, indent);
    return out;
}

}  // namespace tyndall
