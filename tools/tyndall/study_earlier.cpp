#include "study_earlier.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "core/error.h"
#include "core/paths.h"

namespace tyndall {

EarlierErrors::EarlierErrors(const std::filesystem::path& file) : file_(file) {
    const std::string text = paths::read_file(file);
    try {
        const nlohmann::json all = nlohmann::json::parse(text);
        if (all.at("tyndall_measure") != 1) throw Error("another version");
        program_ = all.at("facts").at("program");
        for (const nlohmann::json& from : all.at("scenes")) {
            measure::SceneResults& scene = scenes_.emplace_back();
            scene.name = from.at("name");
            scene.reference = from.at("reference");
            scene.noise_floor = from.at("noise_floor").is_null() ? -1.0 : from.at("noise_floor").get<double>();
            for (const nlohmann::json& row : from.at("rows")) scene.rows.push_back(measure::row_from_json(row));
        }
    } catch (const std::exception& error) {
        throw Error(file.string() + ": is not what tyndall measure --json writes: " + error.what());
    }
}

const measure::SceneResults& EarlierErrors::scene(const std::string& name) const {
    const auto found = std::ranges::find(scenes_, name, &measure::SceneResults::name);
    if (found == scenes_.end()) throw Error(file_.string() + ": has no scene '" + name + "'");
    return *found;
}

void EarlierErrors::fill(measure::SceneResults& results) const {
    const measure::SceneResults& earlier = scene(results.name);
    results.reference = earlier.reference;
    results.noise_floor = earlier.noise_floor;
}

void EarlierErrors::fill(const std::string& scene_name, const std::string& label, measure::Row& row) const {
    const auto& rows = scene(scene_name).rows;
    const auto found = std::ranges::find(rows, label, &measure::Row::label);
    if (found == rows.end() || found->metrics.empty())
        throw Error(file_.string() + ": has no errors of '" + label + "' on '" + scene_name + "'");
    row.metrics = found->metrics;
    row.notes = found->notes;
}

}  // namespace tyndall
