#include "geometry/text_scanner.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <limits>

#include "core/error.h"

namespace tyndall {

bool TextScanner::next_line() {
    if (rest_.empty()) return false;
    const size_t end = rest_.find('\n');
    line_ = rest_.substr(0, end);
    rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + 1);
    ++line_number_;
    return true;
}

std::string_view TextScanner::word() {
    for (;;) {
        const size_t begin = line_.find_first_not_of(" \t\r");
        if (begin == std::string_view::npos) return {};
        line_.remove_prefix(begin);
        if (line_[0] == '#') return {};
        if (line_[0] != '\\') break;
        if (!next_line()) return {};
    }
    const std::string_view found = line_.substr(0, line_.find_first_of(" \t\r\\"));
    line_.remove_prefix(found.size());
    return found;
}

std::string_view TextScanner::next_word() {
    for (;;) {
        const std::string_view found = word();
        if (!found.empty()) return found;
        if (!next_line()) fail("the file ends too early: it is truncated");
    }
}

float TextScanner::number(std::string_view word) const {
    std::string_view digits = word;
    if (digits.starts_with('+')) digits.remove_prefix(1);
    double value = 0;
    const auto [end, problem] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (problem != std::errc{} || end != digits.data() + digits.size() ||
        !(std::abs(value) <= static_cast<double>(std::numeric_limits<float>::max())))
        fail(word.empty() ? "a number is missing" : fmt::format("'{}' is no number", word), "a finite number");
    return static_cast<float>(value);
}

long long TextScanner::whole(std::string_view word) const {
    long long value = 0;
    const auto [end, problem] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (problem != std::errc{} || end != word.data() + word.size())
        fail(word.empty() ? "a number is missing" : fmt::format("'{}' is no whole number", word));
    return value;
}

void TextScanner::fail(std::string message, std::string expected) const {
    throw Error(Diagnostic{{source_, line_number_, 1}, std::move(message), std::move(expected), {}});
}

}  // namespace tyndall
