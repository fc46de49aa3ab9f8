// Results as tables and plots.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "measure/results.h"

namespace tyndall::measure {
namespace {

constexpr std::pair<const char*, const char*> kLabels[] = {
    {"relmse", "relMSE"}, {"flip", "FLIP"}, {"hdr_flip", "HDR-FLIP"}, {"worst_block", "worst block"}};

std::string label_of(const std::string& metric) {
    if (metric.starts_with("frame_")) return label_of(metric.substr(6)) + " of one frame";
    for (const auto& [name, label] : kLabels)
        if (metric == name) return label;
    std::string text = metric;
    std::ranges::replace(text, '_', ' ');
    return text;
}

/// Three significant digits.
std::string number(double value) {
    return std::isfinite(value) ? fmt::format("{:.3g}", value) : "not finite";
}

std::string metric_cell(const Row& row, const std::string& name) {
    const auto found = row.metrics.find(name);
    return found == row.metrics.end() ? "" : number(found->second);
}

/// "1.002 (1.001 1.002 1.004)": overall, and red, green and blue where they differ.
std::string mean_cell(const Row& row) {
    const auto mean = row.metrics.find("mean_ratio");
    if (mean == row.metrics.end()) return "";
    std::string text = fmt::format("{:.4f}", mean->second), channels;
    bool differ = false;
    for (const char* channel : {"mean_ratio.r", "mean_ratio.g", "mean_ratio.b"}) {
        const auto found = row.metrics.find(channel);
        if (found == row.metrics.end()) return text;
        differ = differ || std::abs(found->second - mean->second) > 5e-4;
        channels += fmt::format("{}{:.4f}", channels.empty() ? "" : " ", found->second);
    }
    return differ ? text + " (" + channels + ")" : text;
}

std::string parameters_of(const Row& row) {
    std::string text;
    for (const auto& [name, value] : row.parameters)
        text += (text.empty() ? "" : ", ") + (name.empty() ? "" : name + " ") + value;
    return text;
}

/// The plots' metrics first, then what else a reader asks for.
std::vector<std::string> columns_of(const Results& results) {
    if (!results.compare) return {};
    std::vector<std::string> columns = results.plots;
    for (const char* more : {"relmse", "frame_relmse", "flip", "worst_block"})
        if (std::ranges::find(columns, more) == columns.end()) columns.emplace_back(more);
    return columns;
}

std::string above_cell(const std::optional<double>& value) {
    return value ? fmt::format("{:.1f}", *value) : "";
}

std::vector<std::string> line_of(const Results& results, const Row& row) {
    std::vector<std::string> line{(row.on_front ? "● " : "") + row.technique, parameters_of(row)};
    if (!row.problem.empty()) {
        line.push_back((row.refused ? "cannot: " : "failed: ") + row.problem);
        return line;
    }
    line.push_back(fmt::format("{:.1f}", row.ms));
    if (!results.baseline.empty()) line.push_back(above_cell(row.ms_above));
    line.push_back(fmt::format(
        "{:.1f}", results.baseline.empty() ? row.processor_ms : row.processor_ms_above.value_or(row.processor_ms)));
    for (const std::string& metric : columns_of(results)) {
        std::string cell = metric_cell(row, metric);
        if (metric == "relmse" && row.within_noise) cell += " ≈";
        line.push_back(std::move(cell));
    }
    if (results.compare) line.push_back(mean_cell(row));
    line.push_back(fmt::format("{:.1f}", row.target_bytes / 1e6));
    return line;
}

/// One paragraph on what a scene's rows were held against.
std::string about(const SceneResults& scene) {
    std::string text = fmt::format("{}x{} pixels", scene.size.x, scene.size.y);
    if (scene.supersample > 1)
        text += fmt::format(", compared at {0}x{0} samples a pixel, timed at one", scene.supersample);
    if (!scene.reference.empty()) text += "; reference: " + scene.reference;
    if (scene.noise_floor >= 0) text += fmt::format("; its noise alone gives a relMSE of {:.2g}", scene.noise_floor);
    return text;
}

}  // namespace

Table table_of(const Results& results, const SceneResults& scene) {
    Table table;
    table.head = {"technique", "parameters", "frame, ms"};
    if (!results.baseline.empty()) table.head.emplace_back("above baseline, ms");
    table.head.emplace_back(results.baseline.empty() ? "processors, ms" : "processors above baseline, ms");
    for (const std::string& metric : columns_of(results)) table.head.push_back(label_of(metric));
    if (results.compare) table.head.emplace_back("mean ratio");
    table.head.emplace_back("targets, MB");
    for (const Row& row : scene.rows) table.lines.push_back(line_of(results, row));
    for (auto& line : table.lines) line.resize(table.head.size());
    return table;
}

std::string markdown_of(const Results& results) {
    const auto row_text = [](const std::vector<std::string>& cells) {
        std::string text = "|";
        for (std::string cell : cells) {
            for (size_t at = 0; (at = cell.find_first_of("|\n", at)) != std::string::npos; at += 2)
                cell.replace(at, 1, cell[at] == '|' ? "\\|" : "; ");
            text += " " + cell + " |";
        }
        return text + "\n";
    };
    std::string text;
    for (const SceneResults& scene : results.scenes) {
        const Table table = table_of(results, scene);
        text += "### " + scene.name + "\n" + (scene.doc.empty() ? "" : scene.doc + "\n") + about(scene) + ".\n\n" +
                row_text(table.head) + row_text(std::vector<std::string>(table.head.size(), "---"));
        for (const auto& line : table.lines) text += row_text(line);
        text += "\n";
    }
    if (results.compare) text += "● is on the Pareto front; ≈ is no more than twice the noise of the reference.\n\n";
    for (const auto& [name, value] : results.facts) text += name + ": " + value + "  \n";
    return text;
}

std::string html_of(const Table& table) {
    std::string text = "<table><thead><tr>";
    for (const std::string& cell : table.head) text += "<th scope=\"col\">" + escaped(cell) + "</th>";
    text += "</tr></thead><tbody>\n";
    for (const auto& line : table.lines) {
        text += "<tr>";
        for (const std::string& cell : line) text += "<td>" + escaped(cell) + "</td>";
        text += "</tr>\n";
    }
    return text + "</tbody></table>\n";
}

Plot plot_of(const Results& results, const SceneResults& scene, const std::string& metric) {
    Plot plot;
    plot.id = plain_name(scene.name + "-" + metric);
    plot.title = scene.name + ": " + label_of(metric) + " against time";
    plot.x_label = clock_label(results);
    plot.y_label = label_of(metric);
    int below = 0;
    if (metric == "relmse") plot.noise_floor = std::max(scene.noise_floor, 0.0);
    for (const Row& row : scene.rows) {
        const auto cost = cost_of(results, row);
        const auto error = row.metrics.find(metric);
        if (!cost || error == row.metrics.end()) continue;
        below += *cost <= 0 ? 1 : 0;
        if (plot.series.empty() || plot.series.back().name != row.technique) plot.series.push_back({row.technique});
        PlotSeries& series = plot.series.back();
        PlotPoint point{*cost, error->second};
        for (const auto& [name, value] : row.parameters) point.label += (point.label.empty() ? "" : ", ") + value;
        point.title = fmt::format("{}: {:.2f} ms, {} {:.3g}", row.label, *cost, label_of(metric), error->second);
        point.within_noise = row.within_noise && metric == "relmse";
        series.joined = series.joined && row.parameters.size() == 1;
        series.points.push_back(std::move(point));
        for (const auto& [name, value] : row.parameters)
            if (!name.empty() && plot.note.find(name) == std::string::npos)
                plot.note += (plot.note.empty() ? "beside the markers: " : ", ") + name;
    }
    if (below > 0)
        plot.note += fmt::format("{}not drawn: {} of no measurable cost", plot.note.empty() ? "" : "; ", below);
    plot.description = fmt::format("{} over {} on logarithmic axes; {}.", plot.y_label, plot.x_label, about(scene));
    return plot;
}

Plot cost_plot_of(const Results& results, const SceneResults& scene, const std::string& parameter) {
    Plot plot{.id = plain_name(scene.name + "-" + parameter), .title = scene.name + ": time over " + parameter};
    plot.front = false;
    plot.x_label = parameter;
    plot.y_label = clock_label(results);
    for (const Row& row : scene.rows) {
        const auto has = [&](const auto& named) { return named.first == parameter; };
        const auto value = std::ranges::find_if(row.parameters, has);
        const auto cost = cost_of(results, row);
        if (!cost || value == row.parameters.end()) continue;
        std::string name = row.technique;  // what else it varies makes another line
        for (const auto& other : row.parameters)
            if (!has(other)) name += ", " + (other.first.empty() ? "" : other.first + " ") + other.second;
        auto series = std::ranges::find(plot.series, name, &PlotSeries::name);
        if (series == plot.series.end()) series = plot.series.insert(series, {name});
        const double x = std::strtod(value->second.c_str(), nullptr);
        series->points.push_back(
            {x, *cost, fmt::format("{:.0f}", *cost), fmt::format("{}: {:.2f} ms", row.label, *cost)});
    }
    plot.note = "beside the markers: ms";
    plot.description = fmt::format("{} over {} on logarithmic axes; {}.", plot.y_label, parameter, about(scene));
    return plot;
}

std::vector<Plot> plots_of(const Results& results, const SceneResults& scene) {
    std::vector<Plot> plots;
    if (results.compare)
        for (const std::string& metric : results.plots) plots.push_back(plot_of(results, scene, metric));
    for (const std::string& parameter : results.against) {
        Plot plot = cost_plot_of(results, scene, parameter);
        if (!plot.series.empty()) plots.push_back(std::move(plot));
    }
    return plots;
}

}  // namespace tyndall::measure
