#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "measure/log_axis.h"
#include "measure/pareto.h"
#include "measure/plot.h"

namespace tyndall::measure {
namespace {

TEST(ParetoFront, KeepsWhatNothingBeats) {
    const double inf = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();
    const std::vector<Outcome> outcomes{{4, 1}, {1, 5}, {2, 5}, {3, 2}, {3, 3}, {2, 4}, {9, 1}, {nan, 0}, {0.5, inf}};
    EXPECT_EQ(pareto_front(outcomes), (std::vector<size_t>{1, 5, 3, 0}));
    EXPECT_TRUE(pareto_front({}).empty());
}

TEST(ParetoFront, OfEqualsIsTheFirst) {
    const std::vector<Outcome> outcomes{{1, 1}, {1, 1}, {2, 1}};
    EXPECT_EQ(pareto_front(outcomes), (std::vector<size_t>{0}));
}

TEST(ParetoFront, IsWhatAnExhaustiveSearchFinds) {
    std::vector<Outcome> outcomes;
    for (int i = 0; i < 300; ++i) outcomes.push_back({std::fmod(i * 0.618, 1.0), std::fmod(i * 0.7548, 1.0)});
    std::vector<bool> on_front(outcomes.size());
    for (const size_t i : pareto_front(outcomes)) on_front[i] = true;
    for (size_t i = 0; i < outcomes.size(); ++i) {
        bool beaten = false;
        for (const Outcome& other : outcomes)
            beaten = beaten || (other.cost < outcomes[i].cost && other.error <= outcomes[i].error) ||
                     (other.cost <= outcomes[i].cost && other.error < outcomes[i].error);
        EXPECT_EQ(on_front[i], !beaten) << i;
    }
}

TEST(LogAxis, PutsDecadesEvenlyAndLabelsThem) {
    const LogAxis axis(1e-4, 1, 500, 100);
    EXPECT_NEAR(axis.at(1e-3) - axis.at(1e-4), axis.at(1e-1) - axis.at(1e-2), 1e-9);
    EXPECT_LT(axis.at(1), axis.at(1e-4));
    std::vector<std::string> labels;
    for (const Tick& tick : axis.ticks()) {
        EXPECT_GE(tick.at, 100 - 1e-9);
        EXPECT_LE(tick.at, 500 + 1e-9);
        if (!tick.label.empty()) labels.push_back(tick.label);
    }
    EXPECT_EQ(labels, (std::vector<std::string>{"10⁻⁴", "10⁻³", "0.01", "0.1", "1"}));
    EXPECT_EQ(tick_text(5, -12), "5·10⁻¹²");
    EXPECT_EQ(tick_text(2, 1), "20");
}

TEST(LogAxis, OfOneValueHasRoom) {
    const LogAxis axis(3, 3, 0, 100);
    EXPECT_NEAR(axis.at(3), 50, 1e-9);
    size_t labelled = 0;
    for (const Tick& tick : axis.ticks()) labelled += tick.label.empty() ? 0 : 1;
    EXPECT_GE(labelled, 3u);
}

/// What is wrong with the nesting of tags and the quoting of attributes; empty = nothing.
std::string malformed(const std::string& xml) {
    std::vector<std::string> open;
    for (size_t at = 0; (at = xml.find('<', at)) != std::string::npos;) {
        const size_t end = xml.find('>', at);
        if (end == std::string::npos) return "a tag is not closed";
        const std::string tag = xml.substr(at + 1, end - at - 1);
        at = end;
        if (tag.find('<') != std::string::npos) return "'<' in tag " + tag;
        if (std::count(tag.begin(), tag.end(), '"') % 2 != 0) return "quotes in tag " + tag;
        const std::string name = tag.substr(tag[0] == '/', tag.find_first_of(" /", 1) - (tag[0] == '/'));
        if (tag[0] == '/') {
            if (open.empty() || open.back() != name) return "</" + name + "> closes nothing";
            open.pop_back();
        } else if (tag.back() != '/') {
            open.push_back(name);
        }
    }
    return open.empty() ? "" : open.back() + " stays open";
}

size_t count(const std::string& text, const std::string& what) {
    size_t found = 0;
    for (size_t at = 0; (at = text.find(what, at)) != std::string::npos; at += what.size()) ++found;
    return found;
}

Plot plot_of_three() {
    Plot plot{.id = "a-plot", .title = "Fog & <dust>", .description = "\"error\" against time"};
    plot.x_label = "time, ms";
    plot.y_label = "relMSE";
    plot.note = "beside the markers: steps";
    plot.noise_floor = 5e-4;
    plot.series = {{"full", {{10, 0.01, "4", "full, steps 4"}, {20, 0.001, "8", "full, steps 8", true}}},
                   {"half", {{5, 0.05, "4", "half <steps> 4"}, {0, 0.04, "0", "free"}, {7, NAN, "n", "nan"}}}};
    return plot;
}

TEST(Plot, IsWellFormedAndHasEveryPointWithItsTitle) {
    const std::string svg = svg_of(plot_of_three());
    EXPECT_EQ(malformed(svg), "") << svg;
    EXPECT_EQ(svg.find("nan"), std::string::npos);
    EXPECT_EQ(svg.find("inf"), std::string::npos);
    for (const char* part : {"Fog &amp; &lt;dust&gt;", "&quot;error&quot;", "<title>full, steps 8</title>",
                             "<title>half &lt;steps&gt; 4</title>", "role=\"img\"", "aria-labelledby=\"a-plot-title",
                             "prefers-color-scheme:dark", ">relMSE</text>", ">time, ms</text>", "class=\"tp-front\"",
                             "noise of the reference", "hollow"})
        EXPECT_NE(svg.find(part), std::string::npos) << part;
    EXPECT_EQ(svg.find("<title>free"), std::string::npos) << "a point without a place on a logarithmic axis is drawn";
    EXPECT_EQ(count(svg, "tp-label\""), 3u) << "a label for each point";
}

TEST(Plot, WithoutPointsSaysSo) {
    Plot plot = plot_of_three();
    plot.series.clear();
    const std::string svg = svg_of(plot);
    EXPECT_EQ(malformed(svg), "");
    EXPECT_NE(svg.find("no point"), std::string::npos);
}

TEST(Plot, CrowdedLabelsAreLeftOutAndMarkersAreNot) {
    Plot plot = plot_of_three();
    plot.series.clear();
    PlotSeries& crowd = plot.series.emplace_back();
    for (int i = 0; i < 100; ++i) crowd.points.push_back({10 + 1e-3 * i, 0.01, "a label", "point"});
    crowd.points.push_back({1000, 1, "far", "far"});
    const std::string svg = svg_of(plot);
    EXPECT_EQ(malformed(svg), "");
    EXPECT_EQ(count(svg, "<title>point</title>"), 100u);
    EXPECT_LT(count(svg, ">a label<"), 10u);
    EXPECT_EQ(count(svg, ">far</text>"), 1u);
}

}  // namespace
}  // namespace tyndall::measure
