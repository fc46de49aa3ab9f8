#include "report/report.h"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <chrono>
#include <nlohmann/json.hpp>
#include <set>

#include "core/build_info.h"
#include "core/error.h"
#include "core/paths.h"
#include "image/compare.h"
#include "image/image_io.h"
#include "report/history.h"
#include "report/pixels.h"

namespace tyndall::report {
namespace fs = std::filesystem;
namespace {

using nlohmann::json;

constexpr int kThumbnailWidth = 320;  // drawn at half of it, for screens of fine pixels
constexpr size_t kPastRuns = 40;      // as many as a sparkline can show

const char* name_of(Kind kind) {
    return kind == Kind::reference ? "reference" : kind == Kind::baseline ? "baseline" : "variant";
}

void check(const Report& report) {
    std::set<std::string> names;
    for (const Entry& entry : report.entries) {
        if (!names.insert(entry.name).second)
            throw Error("two comparisons of a report are called '" + entry.name + "'");
        const auto fits = [&](const Image& image, int channels) {
            return !image.empty() && image.type == Image::Type::f32 && image.channels == channels &&
                   image.width == entry.reference.width && image.height == entry.reference.height;
        };
        if (!fits(entry.reference, 3) || !fits(entry.test, 3))
            throw Error("the pictures of comparison '" + entry.name +
                        "' do not fit a report (expected two of the same size, f32, three channels)");
        for (const Map& map : entry.maps)
            if (!fits(map.values, 1))
                throw Error("map '" + map.name + "' of comparison '" + entry.name +
                            "' does not fit (expected the pictures' size, f32, one channel)");
    }
}

/// A name that any file system takes, and that tells entries apart.
std::string file_stem(size_t index, const std::string& name) {
    std::string stem = fmt::format("{:03}-", index);
    for (const char c : name.substr(0, 60)) {
        const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-';
        stem += plain ? c : '_';
    }
    return stem;
}

std::string now() {
    return fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::chrono::system_clock::now()));
}

json history_json(const std::vector<Run>& runs) {
    json list = json::array();
    for (size_t i = runs.size() > kPastRuns ? runs.size() - kPastRuns : 0; i < runs.size(); ++i)
        list.push_back({{"time", runs[i].time},
                        {"revision", runs[i].revision},
                        {"held", runs[i].held},
                        {"metrics", runs[i].metrics}});
    return list;
}

/// Writes the thumbnails and returns their names.
json write_thumbnails(const fs::path& folder, const std::string& stem, const Entry& entry, double exposure) {
    Image heat = entry.maps.empty() ? relative_error(entry.reference, entry.test) : entry.maps.front().values;
    if (!entry.maps.empty())
        for (float& v : heat.floats()) v /= entry.maps.front().full;
    json names;
    const auto put = [&](const char* which, const Image& picture) {
        const std::string name = "data/" + stem + "-" + which + ".png";
        save_png(folder / name, picture);
        names[which] = name;
    };
    put("reference", developed(thumbnail(entry.reference, kThumbnailWidth), exposure));
    put("test", developed(thumbnail(entry.test, kThumbnailWidth), exposure));
    put("heat", heat_map(thumbnail(heat, kThumbnailWidth)));
    return names;
}

json entry_json(const fs::path& folder, const Entry& entry, size_t index, const std::vector<Run>& runs) {
    const std::string stem = file_stem(index, entry.name);
    const double exposure = exposure_of(entry);
    paths::write_file_atomically(folder / "data" / (stem + ".js"), pixel_script(entry, stem));
    json limits = json::array(), maps = json::array(), worst = json::array();
    for (const Limit& limit : entry.limits)
        limits.push_back({{"metric", limit.metric},
                          {"limit", limit.limit},
                          {"at_least", limit.at_least},
                          {"held", limit.held},
                          {"reason", limit.reason}});
    for (const Map& map : entry.maps) maps.push_back({{"name", map.name}, {"label", map.label}, {"full", map.full}});
    for (const auto& [x, y] : entry.worst) worst.push_back({x, y});
    return {{"id", stem},
            {"name", entry.name},
            {"scene", entry.scene},
            {"kind", name_of(entry.kind)},
            {"reason", entry.reason},
            {"reference_name", entry.reference_name},
            {"test_name", entry.test_name},
            {"width", entry.reference.width},
            {"height", entry.reference.height},
            {"exposure", exposure},
            {"held", entry.held},
            {"metrics", entry.metrics},
            {"limits", limits},
            {"maps", maps},
            {"worst", worst},
            {"notes", entry.notes},
            {"thumbnails", write_thumbnails(folder, stem, entry, exposure)},
            {"history", history_json(runs)}};
}

void replace(std::string& text, std::string_view mark, std::string_view with) {
    const size_t at = text.find(mark);
    if (at == std::string::npos) throw Error("the report's page.html has no " + std::string(mark));
    text.replace(at, mark.size(), with);
}

/// page.html with its style, its script and the data inside.
std::string page(const json& data) {
    const fs::path source = paths::root() / "tools" / "report";
    std::string text = paths::read_file(source / "page.html");
    std::string numbers = data.dump(-1, ' ', false, json::error_handler_t::replace);
    // "</script>" in a name must not end the script.
    for (size_t at = 0; (at = numbers.find("</", at)) != std::string::npos; at += 3) numbers.replace(at, 2, "<\\/");
    replace(text, "/*{{style}}*/", paths::read_file(source / "page.css"));
    std::string script;
    for (const char* part : {"format.js", "table.js", "picture.js", "viewer.js", "page.js"})
        script += paths::read_file(source / part);
    replace(text, "/*{{script}}*/", script);
    replace(text, "/*{{data}}*/", "const tyndall_report = " + numbers + ";");
    return text;
}

}  // namespace

void write_report(const fs::path& folder, const Report& report) {
    check(report);
    std::error_code failed;
    fs::create_directories(folder / "data", failed);
    if (failed) throw Error(Diagnostic{{folder.string()}, "the report's folder cannot be made: " + failed.message()});
    Run run;
    run.time = report.time.empty() ? now() : report.time;
    run.revision = build_info().revision;
    const fs::path history_file = report.history.empty() ? folder / "history.jsonl" : report.history;
    append_history(history_file, report.entries, run);
    const auto history = load_history(history_file);
    json data = {{"title", report.title},   {"introduction", report.introduction},
                 {"time", run.time},        {"revision", run.revision},
                 {"facts", json::array()},  {"sections", json::array()},
                 {"entries", json::array()}};
    for (const auto& [key, value] : report.facts) data["facts"].push_back({key, value});
    for (const Section& section : report.sections)
        data["sections"].push_back({{"title", section.title}, {"html", section.html}});
    for (size_t i = 0; i < report.entries.size(); ++i)
        data["entries"].push_back(entry_json(folder, report.entries[i], i, history.at(report.entries[i].name)));
    paths::write_file_atomically(folder / "index.html", page(data));
}

}  // namespace tyndall::report
