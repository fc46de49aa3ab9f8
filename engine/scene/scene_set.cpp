#include <algorithm>
#include <charconv>

#include "scene/scene_file_state.h"
#include "scene/scene_structure.h"
#include "scene/text_patch.h"

namespace tyndall {
namespace {

using Kind = JsonValue::Kind;

std::vector<std::string> split_pointer(std::string_view pointer) {
    if (!pointer.starts_with('/'))
        throw Error(Diagnostic{{}, "'" + std::string(pointer) + "' is no JSON pointer", "such as /render/path", {}});
    std::vector<std::string> tokens;
    for (size_t i = 0; i < pointer.size(); ++i) {
        if (pointer[i] == '/') {
            tokens.emplace_back();
        } else if (pointer[i] == '~') {
            const char code = i + 1 < pointer.size() ? pointer[++i] : '\0';
            if (code != '0' && code != '1')
                throw Error(Diagnostic{{}, "'~' in a JSON pointer stands before 0 or 1", "~0 for ~, ~1 for /", {}});
            tokens.back() += code == '0' ? '~' : '/';
        } else {
            tokens.back() += pointer[i];
        }
    }
    return tokens;
}

/// JSON as it is; a plain word as a string, since quoting quotes in a shell is no pleasure.
std::string value_text(std::string_view given) {
    try {
        const JsonDocument document = parse_json(std::string(given), "value");
        return std::string(document.raw(document.root));
    } catch (const Error&) {
        const auto plain = [](char c) {
            return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                   std::string_view("_-./: ").find(c) != std::string_view::npos;
        };
        const bool word = !given.empty() && ((given[0] | 32) >= 'a' && (given[0] | 32) <= 'z');
        if (!word || !std::ranges::all_of(given, plain)) throw;
        return json_quote(given);
    }
}

class Walk {
 public:
    Walk(const JsonDocument& document, std::string_view pointer) : document_(document), pointer_(pointer) {}

    [[nodiscard]] const JsonValue& item(const JsonValue& array, const std::string& token, bool entities) const {
        size_t index = 0;
        const auto [end, failed] = std::from_chars(token.data(), token.data() + token.size(), index);
        if (failed == std::errc{} && end == token.data() + token.size() && index < array.items.size())
            return array.items[index];
        std::vector<std::string> names;
        if (entities) {
            for (const JsonValue& entity : array.items) {
                names.push_back(text_member(entity, "name"));
                if (!token.empty() && names.back() == token) return entity;
            }
        }
        const std::string range =
            array.items.empty() ? "no index: it is empty" : "0 to " + std::to_string(array.items.size() - 1);
        throw Error(Diagnostic{document_.locate(array.begin, std::string(pointer_)), "there is no '" + token + "'",
                               entities ? range + " or the name of an entity" : range, nearest_name(token, names)});
    }

    [[noreturn]] void fail(const JsonValue& at, const std::string& token) const {
        throw Error(Diagnostic{document_.locate(at.begin, std::string(pointer_)),
                               "'" + token + "' cannot be inside " + std::string(at.kind_name()),
                               {},
                               {}});
    }

 private:
    const JsonDocument& document_;
    std::string_view pointer_;
};

}  // namespace

std::string set_in_scene(const JsonDocument& document, std::string_view pointer, std::string_view json_value) {
    const std::vector<std::string> tokens = split_pointer(pointer);
    std::string value = value_text(json_value);
    const Walk walk(document, pointer);
    TextPatch patch(document);
    const JsonValue* at = &document.root;
    for (size_t i = 0; i < tokens.size(); ++i) {
        if (at->is(Kind::array)) {
            at = &walk.item(*at, tokens[i], i == 1 && tokens[0] == "entities");
        } else if (!at->is(Kind::object)) {
            walk.fail(*at, tokens[i]);
        } else if (const JsonMember* member = at->find(tokens[i])) {
            at = &member->value;
        } else {
            // Not written so far: the objects that are missing on the way come with it.
            for (size_t inner = tokens.size() - 1; inner > i; --inner)
                value = "{ " + json_quote(tokens[inner]) + ": " + value + " }";
            patch.change_members(*at, {}, {json_quote(tokens[i]) + ": " + value});
            return patch.apply();
        }
    }
    patch.replace(*at, value);
    return patch.apply();
}

}  // namespace tyndall
