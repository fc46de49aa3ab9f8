#pragma once
/// What a plot is put together from: markers, a legend, labels that keep out of each other's way.

#include <cstddef>
#include <string>
#include <vector>

#include "measure/plot.h"

namespace tyndall::measure {

/// After so many series colours come again; shapes after another number, so that pairs do so late.
inline constexpr size_t kSeriesColours = 6;

/// The style sheet inside an SVG: colours for light and for dark.
[[nodiscard]] const char* plot_style();

/// The marker of series number `series` around a place, in the colour of the element that it is put in.
[[nodiscard]] std::string marker(size_t series, double x, double y);

/// Names of the series beside their markers, and what the front is, in as many lines as it takes.
struct Legend {
    std::string svg;
    double height = 0;
};
[[nodiscard]] Legend legend_of(const Plot& plot, double left, double right);

/// Places texts beside markers where nothing else is.
class Labels {
 public:
    struct Box {
        double left = 0, top = 0, right = 0, bottom = 0;
    };
    explicit Labels(Box field) : field_(field) {}
    /// There is a marker.
    void occupy(double x, double y);
    /// The label of a marker as SVG, or nothing where there is no room.
    [[nodiscard]] std::string place(size_t series, double x, double y, const std::string& text);

 private:
    [[nodiscard]] bool free(const Box& box) const;
    Box field_;
    std::vector<Box> taken_;
};

}  // namespace tyndall::measure
