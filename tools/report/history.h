#pragma once
/// Past runs of a report's entries, for the sparklines.

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "report/report.h"

namespace tyndall::report {

/// What one run said of one entry.
struct Run {
    std::string time;      ///< ISO 8601
    std::string revision;  ///< of the program
    std::map<std::string, double> metrics;
    bool held = true;
};

/// Entry name to its runs, oldest first. A line that cannot be read (a run was killed while it wrote) is left out with
/// a warning in the log; a file that is not there is an empty history. Throws Error when it cannot be opened.
[[nodiscard]] std::map<std::string, std::vector<Run>> load_history(const std::filesystem::path& file);

/// Appends a line for each entry. Throws Error when it cannot be written; earlier lines stay as they were.
void append_history(const std::filesystem::path& file, const std::vector<Entry>& entries, const Run& run);

}  // namespace tyndall::report
