#pragma once
/// What a study found, and how it is told: JSON, a table, plots.

#include <glm/vec2.hpp>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "measure/plot.h"
#include "measure/study.h"

namespace tyndall::measure {

/// One run's outcome. Times in milliseconds a frame.
struct Row {
    std::string scene, technique, label;
    std::vector<std::pair<std::string, std::string>> parameters;
    bool baseline = false;
    std::string problem;                    ///< why there are no numbers; empty = there are
    bool refused = false;                   ///< the problem is that the technique cannot render the scene
    double ms = 0, least_ms = 0;            ///< median and least from a frame's beginning to its end
    double processor_ms = 0;                ///< median of all processors' time
    double target_bytes = 0;                ///< of the frame graph
    double texture_bytes = 0;               ///< all textures, targets among them
    std::map<std::string, double> metrics;  ///< docs/compare.md; "frame_..." without supersampling
    std::optional<double> ms_above;         ///< above the scene's baseline
    std::optional<double> processor_ms_above;
    std::vector<std::string> notes;
    bool on_front = false;      ///< of the study's first plot
    bool within_noise = false;  ///< relmse is at most twice what the reference's own noise gives
};

/// A scene's rows and what they were held against.
struct SceneResults {
    std::string name, doc;
    glm::ivec2 size{0};
    int supersample = 1;
    std::string reference;    ///< for people: samples, orders, or the file
    double noise_floor = -1;  ///< relmse that the reference's noise alone gives; negative = unknown
    std::vector<Row> rows;
};

/// See the file's head.
struct Results {
    std::string study, title, doc;
    Clock clock = Clock::frame;
    std::string baseline;
    std::vector<std::string> plots;
    std::vector<std::string> against;
    bool compare = true;
    std::vector<std::pair<std::string, std::string>> facts;  ///< machine, driver, how it was timed
    std::vector<SceneResults> scenes;
};

/// Fills in what follows from other numbers: times above the baseline, fronts, what is within the noise.
void conclude(Results& results);

/// The time that the plots and the front go by, if the row has it.
[[nodiscard]] std::optional<double> cost_of(const Results& results, const Row& row);
/// What the clock is called, with its unit.
[[nodiscard]] std::string clock_label(const Results& results);

[[nodiscard]] nlohmann::json to_json(const Row& row);
/// Throws nlohmann's exceptions for what to_json did not write.
[[nodiscard]] Row row_from_json(const nlohmann::json& json);
/// docs/measure.md describes the form.
[[nodiscard]] nlohmann::json to_json(const Results& results);

/// A table of a scene's rows: the head, and a line of cells for each.
struct Table {
    std::vector<std::string> head;
    std::vector<std::vector<std::string>> lines;
};
[[nodiscard]] Table table_of(const Results& results, const SceneResults& scene);
[[nodiscard]] std::string markdown_of(const Results& results);
[[nodiscard]] std::string html_of(const Table& table);

/// Error against time of a scene by one metric.
[[nodiscard]] Plot plot_of(const Results& results, const SceneResults& scene, const std::string& metric);
/// Time over a parameter with numbers: what it costs to have more of something.
[[nodiscard]] Plot cost_plot_of(const Results& results, const SceneResults& scene, const std::string& parameter);
/// All plots of a scene.
[[nodiscard]] std::vector<Plot> plots_of(const Results& results, const SceneResults& scene);
/// A name for files and identifiers: letters, digits and '-'.
[[nodiscard]] std::string plain_name(const std::string& name);

}  // namespace tyndall::measure
