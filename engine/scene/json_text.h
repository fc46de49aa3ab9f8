#pragma once
/// A strict JSON (RFC 8259) reader that knows where every value stands in its text, so that errors can point at it and
/// saving can change a value's own bytes only.

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.h"

namespace tyndall {

/// Bounds on what a text may ask of the reader: nesting, bytes, and values in all.
inline constexpr size_t kMaxJsonDepth = 64;
inline constexpr size_t kMaxJsonBytes = size_t{64} << 20;
inline constexpr size_t kMaxJsonValues = 2'000'000;

struct JsonMember;

/// One value and the bytes [begin, end) of the text that it takes.
struct JsonValue {
    enum class Kind : uint8_t { null, boolean, number, string, array, object };
    Kind kind = Kind::null;
    bool boolean = false;
    double number = 0.0;
    std::string string;               ///< decoded, UTF-8
    std::vector<JsonValue> items;     ///< of an array
    std::vector<JsonMember> members;  ///< of an object, in the order of the text
    size_t begin = 0;
    size_t end = 0;

    [[nodiscard]] bool is(Kind wanted) const { return kind == wanted; }
    /// The first member of that key, or null; null as well when this is no object.
    [[nodiscard]] const JsonMember* find(std::string_view key) const;
    /// "a number", "an object", ...
    [[nodiscard]] std::string_view kind_name() const;
};

/// One `"key": value` of an object; the quoted key begins at key_begin.
struct JsonMember {
    std::string key;
    size_t key_begin = 0;
    JsonValue value;
};

/// A text and what it says.
struct JsonDocument {
    std::string file;  ///< for messages
    std::string text;
    JsonValue root;

    /// The characters of a value as they stand in the text.
    [[nodiscard]] std::string_view raw(const JsonValue& value) const {
        return std::string_view(text).substr(value.begin, value.end - value.begin);
    }
    /// File, line and column (in characters) of a byte of the text.
    [[nodiscard]] SourceLocation locate(size_t offset, std::string pointer = {}) const;
};

/// Throws Error with line and column of the first thing that is not JSON. A byte order mark is skipped.
[[nodiscard]] JsonDocument parse_json(std::string text, std::string file);

/// `token` as a reference token of a JSON pointer: "/" in front, '~' and '/' escaped.
[[nodiscard]] std::string pointer_token(std::string_view token);
/// A string as JSON text, quoted and escaped.
[[nodiscard]] std::string json_quote(std::string_view text);
/// The shortest decimal text that reads back as the same float; NaN becomes 0 and infinity the largest float, which
/// JSON cannot say.
[[nodiscard]] std::string json_number(float value);

}  // namespace tyndall
