#include "capture_report.h"

#include <fmt/format.h>

#include <algorithm>

#include "image/comparison.h"
#include "report/entry.h"

namespace tyndall {
namespace fs = std::filesystem;
namespace {

report::Kind kind_of(Backing backing) {
    return backing == Backing::truth      ? report::Kind::reference
           : backing == Backing::baseline ? report::Kind::baseline
                                          : report::Kind::variant;
}

const char* word_of(Verdict::Outcome outcome) {
    return outcome == Verdict::Outcome::held ? "held" : outcome == Verdict::Outcome::failed ? "FAILED" : "skipped";
}

std::string escaped(const std::string& text) {
    std::string html;
    for (const char c : text) {
        if (c == '<')
            html += "&lt;";
        else if (c == '>')
            html += "&gt;";
        else if (c == '&')
            html += "&amp;";
        else
            html += c;
    }
    return html;
}

/// The verdict's own numbers are what its limits were held against: FLIP, above all, of the display pictures.
void take_limits(report::Entry& entry, const Compared& compared, const std::string& reason) {
    for (const MeasuredLimit& limit : compared.limits) {
        entry.metrics[limit.metric] = limit.value;
        entry.limits.push_back({limit.metric, limit.limit, limit.at_least, limit.held, reason});
        entry.held = entry.held && limit.held;
    }
}

}  // namespace

void CaptureReport::add(const CaptureFile& capture, const std::string& picture, std::vector<Verdict>& verdicts) {
    for (size_t i = 0; i < verdicts.size(); ++i) {
        Verdict& verdict = verdicts[i];
        for (Compared& compared : verdict.compared) add_entry(capture, picture, capture.expect[i], compared);
        if (verdict.compared.empty()) lines_.push_back({picture, word_of(verdict.outcome), verdict.text});
    }
}

void CaptureReport::add_entry(const CaptureFile& capture, const std::string& picture, const Expectation& wanted,
                              Compared& compared) {
    report::Entry entry;
    entry.name = unique(fmt::format("{}: {} = {}", picture, wanted.of, compared.with));
    entry.scene = fs::path(capture.scene).filename().string();
    entry.kind = kind_of(compared.backing);
    entry.reason = wanted.reason;
    entry.reference_name = compared.with;
    entry.test_name = wanted.of;
    entry.reference = std::move(compared.reference.radiance);
    entry.test = std::move(compared.test);
    (void)report::compare(entry, {}, compared.reference.variance);
    take_limits(entry, compared, wanted.reason);
    if (wanted.display) entry.notes.emplace_back("the display pictures' values, 0 to 1");
    if (wanted.scale != 1.0f) entry.notes.push_back(fmt::format("{} times {}", compared.with, wanted.scale));
    report_.entries.push_back(std::move(entry));
}

/// The history goes by the name: the same expectation must get the same one in every run.
std::string CaptureReport::unique(const std::string& name) const {
    const auto taken = [&](const std::string& candidate) {
        return std::ranges::any_of(report_.entries, [&](const auto& entry) { return entry.name == candidate; });
    };
    std::string candidate = name;
    for (int i = 2; taken(candidate); ++i) candidate = fmt::format("{} ({})", name, i);
    return candidate;
}

std::string CaptureReport::lines_html() const {
    std::string html = "<table><tr><th>Picture</th><th>Verdict</th><th>What was measured</th></tr>";
    for (const Line& line : lines_)
        html += fmt::format("<tr><td>{}</td><td>{}</td><td>{}</td></tr>", escaped(line.picture), line.verdict,
                            escaped(line.text));
    return html + "</table>";
}

void CaptureReport::write(const fs::path& folder, const fs::path& history,
                          std::vector<std::pair<std::string, std::string>> facts) {
    report_.title = "Captures";
    report_.introduction =
        "References are the truth within their noise. Baselines are earlier pictures, which no truth backs. Variants "
        "are other ways to the same picture.";
    report_.facts = std::move(facts);
    report_.history = history;
    if (!lines_.empty()) report_.sections.push_back({"Judged without a second picture, or not compared", lines_html()});
    report::write_report(folder, report_);
}

}  // namespace tyndall
