#pragma once
/// A folder that shows how far pictures are from the truth: a table, and each pair under a wipe, in any browser,
/// without network.

#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "image/image.h"

namespace tyndall::report {

/// What stands behind a comparison; the page says it beside every number.
enum class Kind {
    reference,  ///< a reference that was computed by other means: the truth within its noise
    baseline,   ///< an earlier picture of the same technique: no truth backs it
    variant     ///< another technique or setting that should give the same picture
};

/// A metric that was held against a limit.
struct Limit {
    std::string metric;     ///< a key of Entry::metrics
    double limit = 0;       ///< the metric must not be above this ...
    bool at_least = false;  ///< ... or, with this, not below it
    bool held = true;
    std::string reason;  ///< why the limit is what it is; may be empty
};

/// A one-channel map of where pictures differ.
struct Map {
    std::string name;   ///< short, unique in the entry: "hdr_flip"
    std::string label;  ///< for people: "HDR-FLIP"
    Image values;       ///< f32, one channel, of the entry's size
    float full = 1;     ///< the value that is drawn brightest
};

/// One comparison.
struct Entry {
    std::string name;  ///< unique in the report; the history of an entry goes by it
    std::string scene;
    Kind kind = Kind::reference;
    std::string reason;                     ///< why these two should agree; may be empty
    std::string reference_name, test_name;  ///< what the pictures are called: file or technique
    Image reference, test;                  ///< scene-linear, f32, three channels, of the same size
    std::map<std::string, double> metrics;  ///< by name, as docs/compare.md lists them
    std::vector<Limit> limits;
    std::vector<Map> maps;                   ///< beside the relative error, which the page computes itself
    std::vector<std::string> notes;          ///< such as where a NaN is
    std::vector<std::pair<int, int>> worst;  ///< left and top pixels of the worst 8x8 blocks, worst first
    bool held = true;                        ///< the verdict
    /// Factor from scene-linear to a display's 0..1; 0: the reference's 99.5th luminance percentile becomes 1.
    double exposure = 0;
};

/// Anything else to show: a Pareto plot, a table.
struct Section {
    std::string title;
    std::string html;  ///< trusted HTML or SVG; the page's style applies to h3, p, table, figure, svg
};

/// What write_report shows.
struct Report {
    std::string title = "Comparison";
    std::string introduction;                                ///< a sentence or two of plain text; may be empty
    std::vector<std::pair<std::string, std::string>> facts;  ///< what made it: revision, driver, machine
    std::vector<Section> sections;                           ///< shown above the table of entries
    std::vector<Entry> entries;
    /// JSON lines, one for each entry and run, which grow with every report; empty: history.jsonl in the folder.
    std::filesystem::path history;
    std::string time;  ///< of this run, ISO 8601; empty: now
};

/// Writes index.html and data/ into `folder`, which is made when absent; what an earlier report left there under the
/// same names is replaced, and the history grows by a line for each entry. Throws Error when something cannot be
/// written, when two entries have one name, or when pictures or maps are of the wrong kind or size.
void write_report(const std::filesystem::path& folder, const Report& report);

}  // namespace tyndall::report
