#pragma once
/// Changes to a JSON text that touch nothing but what changed.

#include <string>
#include <vector>

#include "scene/json_text.h"

namespace tyndall {

/// Collects replacements, insertions and removals against the spans of one document, then makes the new text.
class TextPatch {
 public:
    explicit TextPatch(const JsonDocument& document) : document_(document) {}

    [[nodiscard]] const JsonDocument& document() const { return document_; }
    [[nodiscard]] bool empty() const { return edits_.empty(); }
    /// Puts one-line JSON in the place of a value; wrapped when it is too long for its line.
    void replace(const JsonValue& value, const std::string& one_line);

    /// What happens to the members of an object or the items of an array: `removed` (one flag for each, or empty) go
    /// with their commas, `added` (one-line `"key": value` or values) come after the last, in the layout of those that
    /// are there.
    void change_members(const JsonValue& container, const std::vector<bool>& removed,
                        const std::vector<std::string>& added);

    /// The text with all changes made.
    [[nodiscard]] std::string apply() const;

 private:
    struct Edit {
        size_t begin;
        size_t end;
        std::string text;
    };
    struct Piece {
        size_t begin;
        size_t end;
    };
    void append(const JsonValue& container, const std::vector<Piece>& pieces, size_t last,
                const std::vector<std::string>& added);
    void refill(const JsonValue& container, const std::vector<std::string>& added);
    [[nodiscard]] size_t line_begin(size_t offset) const;
    [[nodiscard]] size_t line_end(size_t offset) const;
    [[nodiscard]] size_t indentation(size_t offset) const;

    const JsonDocument& document_;
    std::vector<Edit> edits_;
};

}  // namespace tyndall
