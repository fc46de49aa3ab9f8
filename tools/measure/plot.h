#pragma once
/// Error against time as a picture: SVG that stands alone or in a page, light or dark.

#include <string>
#include <vector>

namespace tyndall::measure {

/// One run.
struct PlotPoint {
    double x = 0, y = 0;        ///< above 0; others are not drawn
    std::string label;          ///< short, drawn beside the marker where there is room
    std::string title;          ///< shown when the pointer rests on it, and read aloud
    bool within_noise = false;  ///< drawn hollow
};

/// One technique: its points have a shape and a colour of their own.
struct PlotSeries {
    std::string name;
    std::vector<PlotPoint> points;
    bool joined = true;  ///< a line from each to the next
};

/// Logarithmic axes. Where of both less is better, the Pareto front is drawn.
struct Plot {
    std::string id;  ///< unique in a page: letters, digits, '-'
    std::string title;
    std::string description;  ///< for those who cannot see it
    std::string x_label, y_label;
    std::string note;  ///< a line below the axes, such as what the labels are
    bool front = true;
    double noise_floor = 0;  ///< y below which the reference's noise is all; 0 = none is drawn
    std::vector<PlotSeries> series;
};

/// The whole <svg> element. Without a point that can be drawn it says so.
[[nodiscard]] std::string svg_of(const Plot& plot);

/// Text for the inside of XML and HTML elements and attributes; control characters become spaces.
[[nodiscard]] std::string escaped(std::string_view text);

}  // namespace tyndall::measure
