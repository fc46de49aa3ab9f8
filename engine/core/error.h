#pragma once
/// Errors are for people: where, what, what was expected, and the nearest valid name.

#include <exception>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace tyndall {

/// Where in a user's file something is wrong. Unknown parts stay empty or 0.
struct SourceLocation {
    std::string file;
    int line = 0;         ///< 1-based; 0 = unknown
    int column = 0;       ///< 1-based; 0 = unknown
    std::string pointer;  ///< JSON pointer into the file, such as "/entities/3/medium"
};

/// One thing that is wrong, for a person to read.
struct Diagnostic {
    SourceLocation where;
    std::string message;     ///< what is wrong, without full stop
    std::string expected;    ///< what would be right; may be empty
    std::string suggestion;  ///< the nearest valid name; may be empty

    /// "chapel.json:12:7: /entities/3/medum: unknown component 'medum' (expected ...; did you mean 'medium'?)"
    [[nodiscard]] std::string text() const;
};

/// Thrown for bad input or a bad environment while loading; never inside a frame. Carries every problem found at once.
class Error : public std::exception {
 public:
    explicit Error(std::string message);
    explicit Error(Diagnostic diagnostic);
    explicit Error(std::vector<Diagnostic> diagnostics);
    ~Error() override;
    Error(const Error&);
    Error& operator=(const Error&);

    /// Adds the step that was under way ("loading scene chapel.json"); outer steps are added last and printed first.
    Error& within(std::string step);

    [[nodiscard]] std::span<const Diagnostic> diagnostics() const { return diagnostics_; }
    /// All diagnostics, a line each, after the context chain.
    [[nodiscard]] const char* what() const noexcept override;

 private:
    void compose();
    std::vector<Diagnostic> diagnostics_;
    std::vector<std::string> context_;
    std::string text_;
};

/// The candidate with the smallest edit distance to `name`, or empty when none is near (more than a third of it
/// differs).
[[nodiscard]] std::string nearest_name(std::string_view name, std::span<const std::string> candidates);

}  // namespace tyndall
