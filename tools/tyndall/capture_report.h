#pragma once
/// What `tyndall capture` judged, as a report.

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "app/expectations.h"
#include "report/report.h"

namespace tyndall {

/// Collects verdicts; a comparison becomes an entry, what was judged or skipped without one a line of a table.
class CaptureReport {
 public:
    /// `picture`: what the capture's pictures of this camera are called, `scene`: the scene's file.
    void add(const CaptureFile& capture, const std::string& picture, std::vector<Verdict>& verdicts);
    /// Throws Error when it cannot be written.
    void write(const std::filesystem::path& folder, const std::filesystem::path& history,
               std::vector<std::pair<std::string, std::string>> facts);

 private:
    struct Line {
        std::string picture, verdict, text;
    };
    void add_entry(const CaptureFile& capture, const std::string& picture, const Expectation& wanted,
                   Compared& compared);
    [[nodiscard]] std::string unique(const std::string& name) const;
    [[nodiscard]] std::string lines_html() const;

    report::Report report_;
    std::vector<Line> lines_;
};

}  // namespace tyndall
