#pragma once
/// Everything that is wrong with a JSON document, collected while it is read.

#include <string>
#include <string_view>
#include <vector>

#include "scene/json_text.h"

namespace tyndall {

/// Diagnostics with the JSON pointer of where the reader is. Both the document and the list outlive it.
class Problems {
 public:
    /// More are not kept: nobody reads them, and a hostile file could make millions.
    static constexpr size_t kMaximum = 100;

    Problems(const JsonDocument& document, std::vector<Diagnostic>& list) : document_(document), list_(list) {}

    [[nodiscard]] const JsonDocument& document() const { return document_; }
    [[nodiscard]] std::vector<Diagnostic>& list() { return list_; }
    [[nodiscard]] const std::string& pointer() const { return pointer_; }

    /// Something about the value (or the key) that begins at this byte.
    void add(size_t offset, std::string message, std::string expected = {}, std::string suggestion = {}) {
        if (list_.size() < kMaximum)
            list_.push_back(
                {document_.locate(offset, pointer_), std::move(message), std::move(expected), std::move(suggestion)});
    }
    /// A value of the wrong kind: "is a string (expected a number)".
    void wrong_kind(const JsonValue& value, std::string expected) {
        add(value.begin, "is " + std::string(value.kind_name()), std::move(expected));
    }

    /// Goes down by one reference token while it lives.
    class Step {
     public:
        Step(Problems& problems, std::string_view token) : pointer_(problems.pointer_), length_(pointer_.size()) {
            pointer_ += pointer_token(token);
        }
        Step(Problems& problems, size_t index) : Step(problems, std::to_string(index)) {}
        ~Step() { pointer_.resize(length_); }
        Step(const Step&) = delete;
        Step& operator=(const Step&) = delete;

     private:
        std::string& pointer_;
        size_t length_;
    };

 private:
    const JsonDocument& document_;
    std::vector<Diagnostic>& list_;
    std::string pointer_;
};

}  // namespace tyndall
