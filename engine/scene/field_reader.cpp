#include "scene/field_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace tyndall {
namespace {

using Kind = JsonValue::Kind;

/// "{ a, b }" of what is not empty.
class Leftovers {
 public:
    void add(std::string_view key, std::string_view json) {
        if (json.empty()) return;
        text_ += (text_.empty() ? "" : ", ") + json_quote(key) + ": " + std::string(json);
    }
    [[nodiscard]] std::string text() const { return text_.empty() ? text_ : "{ " + text_ + " }"; }

 private:
    std::string text_;
};

std::string counted(size_t count, std::string_view noun) {
    return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

/// Vectors lie in memory as JSON lists them; a quaternion as x, y, z, w.
static_assert(offsetof(glm::quat, x) == 0 && offsetof(glm::quat, w) == 3 * sizeof(float));

void read_floats(const Field& field, float* out, const JsonValue& json, Problems& problems) {
    const size_t count = float_count(field.kind);
    const std::string expected = fmt::format("an array of {}", counted(count, "number"));
    if (!json.is(Kind::array)) return problems.wrong_kind(json, expected);
    if (json.items.size() != count)
        return problems.add(json.begin, "has " + counted(json.items.size(), "value"), expected);
    float values[4];
    bool good = true;
    for (size_t i = 0; i < count; ++i) {
        const Problems::Step step(problems, i);
        good = read_real(field, values[i], json.items[i], problems) && good;
    }
    if (!good) return;
    if (field.kind == FieldKind::quaternion) {
        const float length =
            std::sqrt(values[0] * values[0] + values[1] * values[1] + values[2] * values[2] + values[3] * values[3]);
        if (!(length > 1e-6f) || !std::isfinite(length))
            return problems.add(json.begin, "is no rotation: its length is 0", "a unit quaternion x, y, z, w");
        // Hand-written ones are rounded; those that were saved stay bit for bit.
        if (std::abs(length - 1.0f) > 1e-5f)
            for (float& value : values) value /= length;
    }
    std::copy_n(values, count, out);
}

void read_integer(const Field& field, int32_t& out, const JsonValue& json, Problems& problems) {
    if (!json.is(Kind::number)) return problems.wrong_kind(json, "a whole number");
    const double low = std::max(field.minimum, -2147483648.0);
    const double high = std::min(field.maximum, 2147483647.0);
    if (json.number != std::floor(json.number))
        return problems.add(json.begin, fmt::format("{} is not whole", problems.document().raw(json)),
                            "a whole number");
    if (json.number < low || json.number > high)
        return problems.add(json.begin, fmt::format("{} is out of range", problems.document().raw(json)),
                            range_text(field));
    out = static_cast<int32_t>(json.number);
}

void read_enumeration(const Field& field, void* at, const JsonValue& json, Problems& problems) {
    if (!json.is(Kind::string)) return problems.wrong_kind(json, join_names(field.names));
    const auto found = std::find(field.names.begin(), field.names.end(), json.string);
    if (found == field.names.end())
        return problems.add(json.begin, "unknown value '" + json.string + "'", join_names(field.names),
                            nearest_name(json.string, field.names));
    field.set_enum(at, found - field.names.begin());
}

std::string read_choice(const Field& field, void* at, const JsonValue& json, Problems& problems,
                        UnknownFields unknown) {
    const std::string expected = "an object with exactly one key: " + join_names(field.names);
    if (!json.is(Kind::object)) return problems.wrong_kind(json, expected), std::string{};
    if (json.members.size() != 1)
        return problems.add(json.begin, "has " + counted(json.members.size(), "key"), expected), std::string{};
    const JsonMember& member = json.members.front();
    const auto found = std::find(field.names.begin(), field.names.end(), member.key);
    if (found == field.names.end()) {
        problems.add(member.key_begin, "unknown choice '" + member.key + "'", join_names(field.names),
                     nearest_name(member.key, field.names));
        return {};
    }
    const auto index = static_cast<size_t>(found - field.names.begin());
    if (!member.value.is(Kind::object)) {
        const Problems::Step step(problems, member.key);
        return problems.wrong_kind(member.value, "an object"), std::string{};
    }
    void* alternative = field.choice_index(at) == index ? field.choice_value(at) : field.choice_emplace(at, index);
    const Problems::Step step(problems, member.key);
    Leftovers left;
    left.add(member.key, read_struct(*field.alternatives[index], alternative, member.value, problems, unknown));
    return left.text();
}

void read_list(const Field& field, void* at, const JsonValue& json, Problems& problems, UnknownFields unknown) {
    if (!json.is(Kind::array)) return problems.wrong_kind(json, "an array");
    const Field element = list_element(field);
    field.list_resize(at, 0);
    field.list_resize(at, json.items.size());
    for (size_t i = 0; i < json.items.size(); ++i) {
        const Problems::Step step(problems, i);
        read_field(element, field.list_at(at, i), json.items[i], problems, unknown);
    }
}

}  // namespace

size_t float_count(FieldKind kind) {
    switch (kind) {
        case FieldKind::real:
            return 1;
        case FieldKind::vec2:
            return 2;
        case FieldKind::vec3:
            return 3;
        case FieldKind::vec4:
        case FieldKind::quaternion:
            return 4;
        default:
            return 0;
    }
}

const Field* find_switch(const StructType& type) {
    const Field* field = type.find("enabled");
    return field && field->kind == FieldKind::boolean ? field : nullptr;
}

Field list_element(const Field& list) {
    Field element = *list.element;
    element.unit = list.unit;
    element.minimum = list.minimum;
    element.maximum = list.maximum;
    return element;
}

std::string range_text(const Field& field) {
    const bool low = std::isfinite(field.minimum);
    const bool high = std::isfinite(field.maximum);
    const std::string unit = field.unit.empty() ? "" : " " + field.unit;
    if (low && high) return fmt::format("{:g} to {:g}{}", field.minimum, field.maximum, unit);
    if (low) return fmt::format("at least {:g}{}", field.minimum, unit);
    if (high) return fmt::format("at most {:g}{}", field.maximum, unit);
    if (field.kind == FieldKind::integer) return "-2147483648 to 2147483647";
    return {};
}

std::vector<std::string> field_names(const StructType& type) {
    std::vector<std::string> names;
    for (const Field& field : type.fields) names.push_back(field.name);
    return names;
}

std::string join_names(const std::vector<std::string>& names) {
    std::string out;
    for (size_t i = 0; i < names.size(); ++i) {
        if (i > 0) out += i + 1 == names.size() ? " or " : ", ";
        out += "'" + names[i] + "'";
    }
    return out;
}

bool read_real(const Field& field, float& out, const JsonValue& json, Problems& problems) {
    if (!json.is(Kind::number)) return problems.wrong_kind(json, "a number"), false;
    const std::string_view raw = problems.document().raw(json);
    // From the text, not from the double: rounding twice could miss the nearest float.
    float value = 0.0f;
    if (std::from_chars(raw.data(), raw.data() + raw.size(), value).ec != std::errc{})
        value = static_cast<float>(json.number);
    if (!std::isfinite(value))
        return problems.add(json.begin, fmt::format("{} is too large", raw), "at most 3.4e38 in size"), false;
    // The bounds as floats: 0.1 written in a file is 0.1 written in a description.
    if (value < static_cast<float>(field.minimum) || value > static_cast<float>(field.maximum)) {
        const std::string unit = field.unit.empty() ? "" : " " + field.unit;
        return problems.add(json.begin, fmt::format("{}{} is out of range", raw, unit), range_text(field)), false;
    }
    out = value;
    return true;
}

std::string read_field(const Field& field, void* at, const JsonValue& json, Problems& problems, UnknownFields unknown) {
    switch (field.kind) {
        case FieldKind::boolean:
            if (json.is(Kind::boolean))
                *static_cast<bool*>(at) = json.boolean;
            else
                problems.wrong_kind(json, "true or false");
            return {};
        case FieldKind::integer:
            return read_integer(field, *static_cast<int32_t*>(at), json, problems), std::string{};
        case FieldKind::real:
            return read_real(field, *static_cast<float*>(at), json, problems), std::string{};
        case FieldKind::vec2:
        case FieldKind::vec3:
        case FieldKind::vec4:
        case FieldKind::quaternion:
            return read_floats(field, static_cast<float*>(at), json, problems), std::string{};
        case FieldKind::text:
            if (json.is(Kind::string))
                *static_cast<std::string*>(at) = json.string;
            else
                problems.wrong_kind(json, "a string");
            return {};
        case FieldKind::enumeration:
            return read_enumeration(field, at, json, problems), std::string{};
        case FieldKind::structure:
            if (const Field* on = find_switch(*field.type); on && json.is(Kind::object))
                *static_cast<bool*>(on->in(at)) = true;
            return read_struct(*field.type, at, json, problems, unknown);
        case FieldKind::choice:
            return read_choice(field, at, json, problems, unknown);
        case FieldKind::list:
            return read_list(field, at, json, problems, unknown), std::string{};
    }
    return {};
}

std::string read_struct(const StructType& type, void* object, const JsonValue& json, Problems& problems,
                        UnknownFields unknown) {
    if (!json.is(Kind::object)) return problems.wrong_kind(json, "an object"), std::string{};
    Leftovers left;
    for (const JsonMember& member : json.members) {
        const Problems::Step step(problems, member.key);
        if (const Field* field = type.find(member.key)) {
            left.add(member.key, read_field(*field, field->in(object), member.value, problems, unknown));
        } else if (unknown == UnknownFields::keep) {
            left.add(member.key, problems.document().raw(member.value));
        } else {
            const std::vector<std::string> names = field_names(type);
            problems.add(member.key_begin, "unknown field '" + member.key + "'",
                         names.empty() ? "no fields" : join_names(names), nearest_name(member.key, names));
        }
    }
    return left.text();
}

}  // namespace tyndall
