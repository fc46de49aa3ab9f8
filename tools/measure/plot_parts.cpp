#include "measure/plot_parts.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <numbers>

namespace tyndall::measure {
namespace {

constexpr double kRadius = 5.5;

/// Pixels that a text of the labels' size takes, about.
double width_of(const std::string& text, double size) {
    double letters = 0;
    for (const char c : text) letters += (static_cast<unsigned char>(c) & 0xC0) != 0x80 ? 1 : 0;
    return 0.56 * size * letters;
}

/// A regular polygon; `turn` in parts of a circle from the top.
std::string polygon(double x, double y, int corners, double radius, double turn) {
    std::string path;
    for (int i = 0; i < corners; ++i) {
        const double angle = 2 * std::numbers::pi * (turn + static_cast<double>(i) / corners - 0.25);
        path += fmt::format("{}{:.1f} {:.1f}", i == 0 ? "M" : "L", x + radius * std::cos(angle),
                            y + radius * std::sin(angle));
    }
    return "<path d=\"" + path + "Z\"/>";
}

}  // namespace

const char* plot_style() {
    return R"(
.tp{font:13px "Inter","Helvetica Neue",Arial,"DejaVu Sans",sans-serif}
.tp .tp-title{font-size:16px;font-weight:600}.tp .tp-small{font-size:11.5px}
.tp-ground{fill:#fff}.tp-ink{fill:#1c1d1f}.tp-quiet{fill:#55595e}
.tp-grid{stroke:#dcdcd8}.tp-minor{stroke:#efefec}.tp-frame{fill:none;stroke:#8b8f94}
.tp-noise{fill:#9aa0a6;fill-opacity:.16}.tp-floor{stroke:#8b8f94;stroke-dasharray:2 3}
.tp-front{fill:none;stroke:#55595e;stroke-width:1.6;stroke-dasharray:7 4}
.tp-join{fill:none;stroke:currentColor;stroke-width:1.4;stroke-opacity:.55}
.tp-s0{color:#1f5fa8}.tp-s1{color:#c2410c}.tp-s2{color:#1b7f4b}.tp-s3{color:#7b3fa0}.tp-s4{color:#8a6d00}.tp-s5{color:#0f7490}
g[class^=tp-s]{fill:currentColor;stroke:currentColor;stroke-width:1.4}
g.tp-hollow{fill:#fff}
.tp-label{fill:currentColor;font-size:11.5px;font-variant-numeric:tabular-nums;stroke:#fff;stroke-width:3px;stroke-linejoin:round;paint-order:stroke}
@media (prefers-color-scheme:dark){
.tp-ground{fill:#1f2123}.tp-ink{fill:#e6e6e3}.tp-quiet{fill:#a9adb1}
.tp-grid{stroke:#3a3d40}.tp-minor{stroke:#2a2c2f}.tp-frame{stroke:#777b80}.tp-front{stroke:#b9bdc1}
.tp-s0{color:#84b6f0}.tp-s1{color:#ff9a62}.tp-s2{color:#6fd49b}.tp-s3{color:#c99af0}.tp-s4{color:#e0c04c}.tp-s5{color:#67cfe3}
g.tp-hollow{fill:#1f2123}.tp-label{stroke:#1f2123}
}
)";
}

std::string marker(size_t series, double x, double y) {
    switch (series % 7) {
        case 0:
            return fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{}\"/>", x, y, kRadius - 0.5);
        case 1:
            return polygon(x, y, 4, kRadius + 0.9, 0.125);
        case 2:
            return polygon(x, y + 0.8, 3, kRadius + 1.2, 0);
        case 3:
            return polygon(x, y, 4, kRadius + 1, 0);
        case 4:
            return polygon(x, y - 0.8, 3, kRadius + 1.2, 0.5);
        case 5:
            return polygon(x, y, 6, kRadius + 0.3, 0);
        default:
            return polygon(x, y, 5, kRadius + 0.8, 0);
    }
}

Legend legend_of(const Plot& plot, double left, double right) {
    constexpr double kLine = 22, kGap = 22;
    Legend legend;
    double x = left, y = 50;
    const auto next = [&](const std::string& name, auto symbol) {
        const double width = 22 + width_of(name, 13) + kGap;
        if (x > left && x + width - kGap > right) x = left, y += kLine;
        legend.svg += symbol(x + 7, y) + fmt::format("<text class=\"tp-ink\" x=\"{:.1f}\" y=\"{}\">{}</text>\n", x + 20,
                                                     y + 4.5, escaped(name));
        x += width;
    };
    bool hollow = false;
    for (size_t s = 0; s < plot.series.size(); ++s) {
        next(plot.series[s].name, [&](double at, double line) {
            return fmt::format("<g class=\"tp-s{}\">{}</g>", s % kSeriesColours, marker(s, at, line));
        });
        for (const PlotPoint& point : plot.series[s].points) hollow = hollow || point.within_noise;
    }
    if (plot.front)
        next("Pareto front", [](double at, double line) {
            return fmt::format("<line class=\"tp-front\" x1=\"{:.1f}\" y1=\"{}\" x2=\"{:.1f}\" y2=\"{}\"/>", at - 9,
                               line, at + 9, line);
        });
    if (hollow)
        next("hollow: within twice the reference's noise", [](double at, double line) {
            return fmt::format("<g class=\"tp-s0 tp-hollow\">{}</g>", marker(0, at, line));
        });
    legend.height = y - 50 + kLine;
    return legend;
}

void Labels::occupy(double x, double y) {
    taken_.push_back({x - kRadius - 1, y - kRadius - 1, x + kRadius + 1, y + kRadius + 1});
}

bool Labels::free(const Box& box) const {
    if (box.left < field_.left || box.right > field_.right || box.top < field_.top || box.bottom > field_.bottom)
        return false;
    for (const Box& other : taken_)
        if (box.left < other.right && other.left < box.right && box.top < other.bottom && other.top < box.bottom)
            return false;
    return true;
}

std::string Labels::place(size_t series, double x, double y, const std::string& text) {
    if (text.empty()) return {};
    const double width = width_of(text, 11.5), high = 11;
    struct Place {
        double left, bottom;
    };
    const double aside = kRadius + 4, above = kRadius + 3;
    const std::array<Place, 6> places{{{x + aside, y + 4},
                                       {x - 0.5 * width, y - above},
                                       {x - 0.5 * width, y + above + high},
                                       {x - aside - width, y + 4},
                                       {x + aside - 2, y - above + 2},
                                       {x - aside + 2 - width, y + above + high - 2}}};
    for (const Place& at : places) {
        const Box box{at.left, at.bottom - high, at.left + width, at.bottom + 1};
        if (!free(box)) continue;
        taken_.push_back(box);
        return fmt::format("<text class=\"tp-s{} tp-label\" x=\"{:.1f}\" y=\"{:.1f}\">{}</text>\n",
                           series % kSeriesColours, at.left, at.bottom, escaped(text));
    }
    return {};
}

std::string escaped(std::string_view text) {
    std::string out;
    for (const char c : text) switch (c) {
            case '&':
                out += "&amp;";
                break;
            case '<':
                out += "&lt;";
                break;
            case '>':
                out += "&gt;";
                break;
            case '"':
                out += "&quot;";
                break;
            default:
                out += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
        }
    return out;
}

}  // namespace tyndall::measure
