#include "scene/json_text.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <functional>
#include <limits>

namespace tyndall {

const JsonMember* JsonValue::find(std::string_view key) const {
    for (const JsonMember& member : members)
        if (member.key == key) return &member;
    return nullptr;
}

std::string_view JsonValue::kind_name() const {
    switch (kind) {
        case Kind::null:
            return "null";
        case Kind::boolean:
            return "a boolean";
        case Kind::number:
            return "a number";
        case Kind::string:
            return "a string";
        case Kind::array:
            return "an array";
        case Kind::object:
            return "an object";
    }
    return "nothing";
}

SourceLocation JsonDocument::locate(size_t offset, std::string pointer) const {
    const std::string_view before = std::string_view(text).substr(0, offset);
    const size_t newline = before.rfind('\n');
    const std::string_view line = newline == std::string_view::npos ? before : before.substr(newline + 1);
    const auto continues = [](char c) { return (static_cast<unsigned char>(c) & 0xc0u) == 0x80u; };
    const auto characters = static_cast<int>(std::count_if(line.begin(), line.end(), std::not_fn(continues)));
    return {file, 1 + static_cast<int>(std::count(before.begin(), before.end(), '\n')), characters + 1,
            std::move(pointer)};
}

std::string pointer_token(std::string_view token) {
    std::string out = "/";
    for (const char c : token) {
        if (c == '~')
            out += "~0";
        else if (c == '/')
            out += "~1";
        else
            out += c;
    }
    return out;
}

std::string json_quote(std::string_view text) {
    static constexpr std::string_view kHex = "0123456789abcdef";
    std::string out = "\"";
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        if (c == '"' || c == '\\') {
            out += '\\';
            out += c;
        } else if (c == '\n') {
            out += "\\n";
        } else if (c == '\t') {
            out += "\\t";
        } else if (byte < 0x20) {
            out += "\\u00";
            out += kHex[byte >> 4u];
            out += kHex[byte & 15u];
        } else {
            out += c;
        }
    }
    return out += '"';
}

std::string json_number(float value) {
    constexpr float kLargest = std::numeric_limits<float>::max();
    if (std::isnan(value)) value = 0.0f;
    value = std::clamp(value, -kLargest, kLargest);
    // Plain digits where people write them so; an exponent outside.
    const float size = std::abs(value);
    const bool plain = size == 0.0f || (size >= 1e-4f && size < 1e9f);
    char buffer[64];
    const auto [end, failed] = std::to_chars(buffer, buffer + sizeof buffer, value,
                                             plain ? std::chars_format::fixed : std::chars_format::scientific);
    return failed == std::errc{} ? std::string(buffer, end) : "0";
}

}  // namespace tyndall
