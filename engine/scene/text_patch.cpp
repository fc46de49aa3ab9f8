#include "scene/text_patch.h"

#include <algorithm>

#include "scene/field_writer.h"

namespace tyndall {
namespace {

/// A `"key": value` or a value, wrapped to start at `column`.
std::string wrap_added(const std::string& added, size_t column, size_t indent, bool member) {
    if (!member) return wrap_json(added, column, indent);
    const JsonDocument object = parse_json("{" + added + "}", {});
    const std::string_view value = object.raw(object.root.members.front().value);
    const std::string key = added.substr(0, added.size() - value.size());
    return key + wrap_json(std::string(value), column + key.size(), indent);
}

}  // namespace

size_t TextPatch::line_begin(size_t offset) const {
    const size_t newline = std::string_view(document_.text).substr(0, offset).rfind('\n');
    return newline == std::string_view::npos ? 0 : newline + 1;
}

size_t TextPatch::line_end(size_t offset) const {
    return std::min(document_.text.find('\n', offset), document_.text.size());
}

size_t TextPatch::indentation(size_t offset) const {
    const size_t begin = line_begin(offset);
    return std::min(document_.text.find_first_not_of(" \t", begin), offset) - begin;
}

void TextPatch::replace(const JsonValue& value, const std::string& one_line) {
    if (document_.raw(value) == one_line) return;
    const size_t column = value.begin - line_begin(value.begin);
    edits_.push_back({value.begin, value.end, wrap_json(one_line, column, indentation(value.begin))});
}

void TextPatch::change_members(const JsonValue& container, const std::vector<bool>& removed,
                               const std::vector<std::string>& added) {
    std::vector<Piece> pieces;
    for (const JsonMember& member : container.members) pieces.push_back({member.key_begin, member.value.end});
    for (const JsonValue& item : container.items) pieces.push_back({item.begin, item.end});
    const auto gone = [&](size_t i) { return i < removed.size() && removed[i]; };

    size_t last_kept = pieces.size();
    for (size_t i = 0; i < pieces.size(); ++i)
        if (!gone(i)) last_kept = i;
    if (last_kept == pieces.size()) {
        if (!pieces.empty() || !added.empty()) refill(container, added);
        return;
    }
    bool kept_before = false;
    for (size_t i = 0; i < pieces.size(); ++i) {
        if (gone(i) && kept_before) edits_.push_back({pieces[i - 1].end, pieces[i].end, {}});
        if (gone(i) && !kept_before) edits_.push_back({pieces[i].begin, pieces[i + 1].begin, {}});
        kept_before = kept_before || !gone(i);
    }
    if (!added.empty()) append(container, pieces, last_kept, added);
}

void TextPatch::append(const JsonValue& container, const std::vector<Piece>& pieces, size_t last,
                       const std::vector<std::string>& added) {
    const bool member = container.is(JsonValue::Kind::object);
    const size_t line = line_begin(pieces[last].begin);
    const size_t first_on_line =
        std::find_if(pieces.begin(), pieces.end(), [&](Piece p) { return p.begin >= line; })->begin;
    const size_t indent = first_on_line - line;
    // A piece alone on its line asks for lines; pieces that share one are joined while there is room, and always in an
    // object that starts far to the right, where a line of its own would look lost.
    const bool starts_line = indentation(pieces[last].begin) == pieces[last].begin - line;
    const bool far_right = indent > kJsonColumns / 4;
    bool own_lines = starts_line && container.begin < line;
    size_t column = line_end(pieces[last].end) - line_begin(pieces[last].end);
    std::string text;
    for (const std::string& one : added) {
        own_lines = own_lines || (!far_right && column + one.size() + 2 > kJsonColumns);
        if (own_lines) {
            text += ",\n" + std::string(indent, ' ') + wrap_added(one, indent, indent, member);
        } else {
            text += ", " + one;
            column += one.size() + 2;
        }
    }
    edits_.push_back({pieces[last].end, pieces[last].end, text});
}

void TextPatch::refill(const JsonValue& container, const std::vector<std::string>& added) {
    const bool member = container.is(JsonValue::Kind::object);
    std::string one_line;
    for (const std::string& one : added) one_line += (one_line.empty() ? "" : ", ") + one;
    if (member)
        one_line = one_line.empty() ? "{}" : "{ " + one_line + " }";
    else
        one_line = "[" + one_line + "]";
    const size_t indent = indentation(container.begin);
    const size_t column = container.begin - line_begin(container.begin);
    edits_.push_back({container.begin, container.end, wrap_json(one_line, column, indent)});
}

std::string TextPatch::apply() const {
    std::vector<const Edit*> order;
    for (const Edit& edit : edits_) order.push_back(&edit);
    // An insertion (an empty span) goes before the removal that begins at the same byte.
    std::stable_sort(order.begin(), order.end(), [](const Edit* a, const Edit* b) {
        return std::pair(a->begin, a->end) < std::pair(b->begin, b->end);
    });
    std::string out;
    size_t done = 0;
    for (const Edit* edit : order) {
        out.append(document_.text, done, edit->begin - done);
        out += edit->text;
        done = edit->end;
    }
    return out.append(document_.text, done);
}

}  // namespace tyndall
