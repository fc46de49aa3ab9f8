#pragma once
/// From described memory to JSON text in the house style: `{ "key": value }` on one line.

#include <string>

#include "ecs/description.h"

namespace tyndall {

/// Whether two values of a field are the same (NaN equals NaN); pointers address the fields themselves.
[[nodiscard]] bool field_equal(const Field& field, const void* a, const void* b);
[[nodiscard]] bool struct_equal(const StructType& type, const void* a, const void* b);

/// The whole value.
[[nodiscard]] std::string write_field(const Field& field, const void* at);
[[nodiscard]] std::string write_struct(const StructType& type, const void* object);

/// Only what differs from `base`: reading it over `base` gives `object`. "{}" when nothing does.
[[nodiscard]] std::string write_field_changes(const Field& field, const void* base, const void* at);
[[nodiscard]] std::string write_struct_changes(const StructType& type, const void* base, const void* object);

/// Breaks one-line JSON text (such as the functions above make) where it would pass the column limit: the first line
/// starts at `column`, further ones are indented from `indent`.
[[nodiscard]] std::string wrap_json(const std::string& one_line, size_t column, size_t indent);

/// The house's line length and indentation step.
inline constexpr size_t kJsonColumns = 120;
inline constexpr size_t kJsonIndent = 2;

}  // namespace tyndall
