#pragma once
// Words and numbers of a text file, with the line for messages; for the readers of this floor.

#include <string>
#include <string_view>

namespace tyndall {

class TextScanner {
 public:
    /// Both must outlive the scanner. `first_line` is the number of the text's first line in its file.
    TextScanner(std::string_view text, const std::string& source, int first_line = 1)
        : rest_(text), line_number_(first_line - 1), source_(source) {}

    /// Goes to the next line; false at the end of the text.
    bool next_line();
    /// The next word of this line; empty at its end. '#' starts a comment; a backslash at its end continues the line.
    std::string_view word();
    /// The next word, of a later line if need be. Throws Error at the end of the text.
    std::string_view next_word();
    /// A word as a finite number, or as a whole one. Throws Error.
    [[nodiscard]] float number(std::string_view word) const;
    [[nodiscard]] long long whole(std::string_view word) const;
    /// What is left of the text after this line.
    [[nodiscard]] std::string_view rest() const { return rest_; }
    [[nodiscard]] int line_number() const { return line_number_; }
    [[noreturn]] void fail(std::string message, std::string expected = {}) const;

 private:
    std::string_view rest_, line_;
    int line_number_;
    const std::string& source_;
};

}  // namespace tyndall
