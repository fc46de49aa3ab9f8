#include "measure/results.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "measure/pareto.h"

namespace tyndall::measure {
namespace {

using nlohmann::json;

void conclude(const Results& results, SceneResults& scene) {
    const Row* baseline = nullptr;
    for (const Row& row : scene.rows)
        if (row.baseline && row.problem.empty()) baseline = &row;
    std::vector<Outcome> outcomes;
    for (Row& row : scene.rows) {
        row.ms_above.reset();
        row.processor_ms_above.reset();
        if (baseline && !row.baseline && row.problem.empty()) {
            row.ms_above = row.ms - baseline->ms;
            row.processor_ms_above = row.processor_ms - baseline->processor_ms;
        }
        const auto relmse = row.metrics.find("relmse");
        row.within_noise =
            relmse != row.metrics.end() && scene.noise_floor > 0 && relmse->second <= 2 * scene.noise_floor;
        row.on_front = false;
        if (!results.compare) continue;
        const auto error = row.metrics.find(results.plots.front());
        outcomes.push_back({cost_of(results, row).value_or(NAN), error == row.metrics.end() ? NAN : error->second});
    }
    for (const size_t i : pareto_front(outcomes)) scene.rows[i].on_front = true;
}

json optional_json(const std::optional<double>& value) {
    return value ? json(*value) : json();
}

}  // namespace

void conclude(Results& results) {
    for (SceneResults& scene : results.scenes) conclude(results, scene);
}

std::optional<double> cost_of(const Results& results, const Row& row) {
    if (row.baseline || !row.problem.empty()) return std::nullopt;
    const bool frame = results.clock == Clock::frame;
    if (!results.baseline.empty()) return frame ? row.ms_above : row.processor_ms_above;
    return frame ? row.ms : row.processor_ms;
}

std::string clock_label(const Results& results) {
    const std::string what = results.clock == Clock::frame ? "time a frame" : "processors' time a frame";
    return results.baseline.empty() ? what + ", ms" : fmt::format("{} above “{}”, ms", what, results.baseline);
}

json to_json(const Row& row) {
    json parameters = json::array();
    for (const auto& [name, value] : row.parameters) parameters.push_back({name, value});
    json all = {{"scene", row.scene},
                {"technique", row.technique},
                {"label", row.label},
                {"parameters", parameters},
                {"baseline", row.baseline},
                {"ms", row.ms},
                {"least_ms", row.least_ms},
                {"metrics", row.metrics},
                {"notes", row.notes},
                {"processor_ms", row.processor_ms},
                {"target_bytes", row.target_bytes},
                {"texture_bytes", row.texture_bytes},
                {"on_front", row.on_front},
                {"within_noise", row.within_noise}};
    all["ms_above"] = optional_json(row.ms_above);
    all["processor_ms_above"] = optional_json(row.processor_ms_above);
    if (!row.problem.empty()) all[row.refused ? "cannot" : "problem"] = row.problem;
    return all;
}

Row row_from_json(const json& json) {
    Row row;
    row.scene = json.at("scene");
    row.technique = json.at("technique");
    row.label = json.at("label");
    for (const auto& pair : json.at("parameters")) row.parameters.emplace_back(pair.at(0), pair.at(1));
    row.baseline = json.at("baseline");
    row.ms = json.at("ms");
    row.least_ms = json.at("least_ms");
    row.processor_ms = json.at("processor_ms");
    row.target_bytes = json.at("target_bytes");
    row.texture_bytes = json.at("texture_bytes");
    for (const auto& [name, value] : json.at("metrics").items())
        row.metrics[name] = value.is_null() ? INFINITY : value.get<double>();
    row.notes = json.at("notes");
    return row;
}

json to_json(const Results& results) {
    json all = {{"tyndall_measure", 1},
                {"study", results.study},
                {"title", results.title},
                {"doc", results.doc},
                {"clock", results.clock == Clock::frame ? "frame" : "processor"},
                {"baseline", results.baseline},
                {"plots", results.plots},
                {"facts", json::object()},
                {"scenes", json::array()}};
    for (const auto& [name, value] : results.facts) all["facts"][name] = value;
    for (const SceneResults& scene : results.scenes) {
        json rows = json::array();
        for (const Row& row : scene.rows) rows.push_back(to_json(row));
        all["scenes"].push_back({{"name", scene.name},
                                 {"size", {scene.size.x, scene.size.y}},
                                 {"supersample", scene.supersample},
                                 {"reference", scene.reference},
                                 {"noise_floor", scene.noise_floor < 0 ? json() : json(scene.noise_floor)},
                                 {"rows", rows}});
    }
    return all;
}

std::string plain_name(const std::string& name) {
    std::string plain;
    for (const char c : name) {
        const bool keeps = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
        plain += keeps ? c : '-';
    }
    return plain;
}

}  // namespace tyndall::measure
