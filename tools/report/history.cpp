#include "report/history.h"

#include <cmath>
#include <cstring>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>
#include <sstream>

#include "core/error.h"
#include "core/log.h"
#include "core/paths.h"

namespace tyndall::report {
namespace {

using nlohmann::json;

/// JSON has no infinity: what is not finite is null there.
double number(const json& value) {
    return value.is_number() ? value.get<double>() : std::numeric_limits<double>::quiet_NaN();
}

void read_line(const std::string& line, std::map<std::string, std::vector<Run>>& history) {
    const json object = json::parse(line);
    Run run;
    run.time = object.at("time").get<std::string>();
    run.revision = object.value("revision", "");
    run.held = object.value("held", true);
    for (const auto& [name, value] : object.at("metrics").items()) run.metrics[name] = number(value);
    history[object.at("entry").get<std::string>()].push_back(std::move(run));
}

}  // namespace

std::map<std::string, std::vector<Run>> load_history(const std::filesystem::path& file) {
    std::map<std::string, std::vector<Run>> history;
    if (!std::filesystem::exists(file)) return history;
    std::istringstream lines(paths::read_file(file));
    std::string line;
    for (int number = 1; std::getline(lines, line); ++number) {
        if (line.empty()) continue;
        try {
            read_line(line, history);
        } catch (const json::exception&) {
            log::warning("{}:{}: not a line of a history of comparisons; it is left out", file.string(), number);
        }
    }
    return history;
}

void append_history(const std::filesystem::path& file, const std::vector<Entry>& entries, const Run& run) {
    std::string text;
    for (const Entry& entry : entries) {
        const json line = {{"time", run.time},
                           {"revision", run.revision},
                           {"entry", entry.name},
                           {"held", entry.held},
                           {"metrics", entry.metrics}};
        text += line.dump(-1, ' ', false, json::error_handler_t::replace) + '\n';
    }
    // A run that was killed here may have left half a line: ours must not join it.
    const bool joins = std::filesystem::exists(file) && std::filesystem::file_size(file) > 0 && [&] {
        std::ifstream in(file, std::ios::binary);
        in.seekg(-1, std::ios::end);
        return in.get() != '\n';
    }();
    std::ofstream out(file, std::ios::binary | std::ios::app);
    out << (joins ? "\n" : "") << text << std::flush;
    if (!out)
        throw Error(
            Diagnostic{{file.string()}, std::string("the history of runs cannot be written: ") + std::strerror(errno)});
}

}  // namespace tyndall::report
