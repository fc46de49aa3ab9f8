#include "core/error.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace tyndall {

std::string Diagnostic::text() const {
    std::string out;
    if (!where.file.empty()) out += where.file + ":";
    if (where.line > 0) out += std::to_string(where.line) + ":";
    if (where.line > 0 && where.column > 0) out += std::to_string(where.column) + ":";
    if (!out.empty()) out += " ";
    if (!where.pointer.empty()) out += where.pointer + ": ";
    out += message;
    if (!expected.empty() || !suggestion.empty()) {
        out += " (";
        if (!expected.empty()) out += "expected " + expected;
        if (!suggestion.empty()) out += (expected.empty() ? "did you mean '" : "; did you mean '") + suggestion + "'?";
        out += ")";
    }
    return out;
}

Error::Error(std::string message) : Error(Diagnostic{{}, std::move(message), {}, {}}) {}
Error::Error(Diagnostic diagnostic) : Error(std::vector<Diagnostic>{std::move(diagnostic)}) {}
Error::Error(std::vector<Diagnostic> diagnostics) : diagnostics_(std::move(diagnostics)) {
    compose();
}
Error::~Error() = default;
Error::Error(const Error&) = default;
Error& Error::operator=(const Error&) = default;

Error& Error::within(std::string step) {
    context_.push_back(std::move(step));
    compose();
    return *this;
}

const char* Error::what() const noexcept {
    return text_.c_str();
}

void Error::compose() {
    text_.clear();
    for (auto step = context_.rbegin(); step != context_.rend(); ++step) text_ += *step + ": ";
    for (size_t i = 0; i < diagnostics_.size(); ++i) {
        if (i > 0) text_ += '\n';
        text_ += diagnostics_[i].text();
    }
}

namespace {

/// Letters to add, drop, replace or swap with their neighbour (optimal string alignment).
size_t edit_distance(std::string_view a, std::string_view b) {
    std::vector<size_t> before(b.size() + 1), last(b.size() + 1), row(b.size() + 1);
    std::iota(row.begin(), row.end(), size_t{0});
    for (size_t i = 0; i < a.size(); ++i) {
        before.swap(last);
        last.swap(row);
        row[0] = i + 1;
        for (size_t j = 0; j < b.size(); ++j) {
            row[j + 1] = std::min({row[j] + 1, last[j + 1] + 1, last[j] + (a[i] == b[j] ? 0 : 1)});
            const bool swapped = i > 0 && j > 0 && a[i] == b[j - 1] && a[i - 1] == b[j];
            if (swapped) row[j + 1] = std::min(row[j + 1], before[j - 1] + 1);
        }
    }
    return row.back();
}

}  // namespace

std::string nearest_name(std::string_view name, std::span<const std::string> candidates) {
    std::string best;
    size_t best_distance = std::max<size_t>(1, name.size() / 3) + 1;
    for (const std::string& candidate : candidates) {
        const size_t distance = edit_distance(name, candidate);
        if (distance < best_distance) {
            best = candidate;
            best_distance = distance;
        }
    }
    return best;
}

}  // namespace tyndall
