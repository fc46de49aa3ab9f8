#pragma once
/// From JSON into described memory: the one reader behind scene files, presets, settings and module reload.

#include <string>

#include "ecs/description.h"
#include "scene/problems.h"

namespace tyndall {

/// What to do with a member that no field has.
enum class UnknownFields {
    report,  ///< a problem, with the nearest name
    keep     ///< return it
};

/// Reads an object into `object`, over the values that it has: missing fields stay as they are. Whatever is wrong is
/// added to `problems` and leaves its field as it was. Returns the unknown members as the text of an object with the
/// same nesting ("{ ... }"), or an empty string.
std::string read_struct(const StructType& type, void* object, const JsonValue& json, Problems& problems,
                        UnknownFields unknown = UnknownFields::report);

/// The same for one field; `at` is the field itself.
std::string read_field(const Field& field, void* at, const JsonValue& json, Problems& problems,
                       UnknownFields unknown = UnknownFields::report);

/// Reads a number with float precision. False, and a problem, when it is none or out of the field's range.
bool read_real(const Field& field, float& out, const JsonValue& json, Problems& problems);

/// The floats of a real, vector or quaternion field; 0 for other kinds.
[[nodiscard]] size_t float_count(FieldKind kind);

/// The boolean "enabled" of a nested object, or null. Writing such an object switches it on: `"shadow": {}`.
[[nodiscard]] const Field* find_switch(const StructType& type);

/// What one element of a list must be: the list's unit and range hold for each.
[[nodiscard]] Field list_element(const Field& list);

/// "0 to 90 deg", "at least 0 1/m", "" without a range.
[[nodiscard]] std::string range_text(const Field& field);

/// The names of a type's fields, for suggestions.
[[nodiscard]] std::vector<std::string> field_names(const StructType& type);
/// "'a', 'b' or 'c'".
[[nodiscard]] std::string join_names(const std::vector<std::string>& names);

}  // namespace tyndall
