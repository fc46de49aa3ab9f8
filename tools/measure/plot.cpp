#include "measure/plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "measure/log_axis.h"
#include "measure/pareto.h"
#include "measure/plot_parts.h"

namespace tyndall::measure {
namespace {

constexpr double kWidth = 820, kLeft = 78, kRight = 24, kBelow = 62, kField = 380, kLineHeight = 20;

bool drawable(const PlotPoint& point) {
    return std::isfinite(point.x) && std::isfinite(point.y) && point.x > 0 && point.y > 0;
}

struct Range {
    double low = std::numeric_limits<double>::infinity(), high = 0;
    void take(double value) { low = std::min(low, value), high = std::max(high, value); }
};

/// Puts one plot together, from the ground up.
class Drawing {
 public:
    explicit Drawing(const Plot& plot) : plot_(plot), legend_(legend_of(plot, kLeft, kWidth - kRight)) {
        top_ = 40 + legend_.height + 10;
        bottom_ = top_ + kField;
        height_ = bottom_ + kBelow + (plot.note.empty() ? 0 : kLineHeight);
        for (const PlotSeries& series : plot.series)
            for (const PlotPoint& point : series.points)
                if (drawable(point)) x_.take(point.x), y_.take(point.y);
        // The floor is worth the room when it is near.
        floor_shown_ = plot.noise_floor > 0 && y_.high > 0 && plot.noise_floor > 0.2 * y_.low;
        if (floor_shown_) y_.take(plot.noise_floor);
    }

    std::string all() {
        head();
        if (y_.high > 0)
            field();
        else
            out_ += fmt::format("<text class=\"tp-ink\" x=\"{}\" y=\"{}\">There is no point to draw.</text>\n", kLeft,
                                top_ + 40);
        return out_ + "</svg>\n";
    }

 private:
    void head() {
        out_ += fmt::format(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"tp\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" "
            "height=\"{1}\" role=\"img\" aria-labelledby=\"{2}-title {2}-about\">\n"
            "<title id=\"{2}-title\">{3}</title>\n<desc id=\"{2}-about\">{4}</desc>\n<style>{5}</style>\n"
            "<rect class=\"tp-ground\" width=\"{0}\" height=\"{1}\" rx=\"6\"/>\n"
            "<text class=\"tp-ink tp-title\" x=\"{6}\" y=\"28\">{3}</text>\n",
            kWidth, height_, plot_.id, escaped(plot_.title), escaped(plot_.description), plot_style(), kLeft);
        out_ += legend_.svg;
    }

    void field() {
        const LogAxis x(x_.low, x_.high, kLeft, kWidth - kRight), y(y_.low, y_.high, bottom_, top_);
        axes(x, y);
        if (floor_shown_) noise(y);
        if (plot_.front) front(x, y);
        markers(x, y);
        out_ += fmt::format("<rect class=\"tp-frame\" x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"/>\n", kLeft, top_,
                            kWidth - kRight - kLeft, kField);
    }

    void axes(const LogAxis& x, const LogAxis& y) {
        for (const Tick& tick : x.ticks()) {
            line(tick.label.empty() ? "tp-minor" : "tp-grid", tick.at, top_, tick.at, bottom_);
            text("tp-quiet", tick.at, bottom_ + 18, "middle", tick.label);
        }
        for (const Tick& tick : y.ticks()) {
            line(tick.label.empty() ? "tp-minor" : "tp-grid", kLeft, tick.at, kWidth - kRight, tick.at);
            text("tp-quiet", kLeft - 8, tick.at + 4, "end", tick.label);
        }
        text("tp-ink", 0.5 * (kLeft + kWidth - kRight), bottom_ + 42, "middle", plot_.x_label);
        out_ += fmt::format(
            "<text class=\"tp-ink\" text-anchor=\"middle\" transform=\"translate(20 {:.1f}) rotate(-90)\">{}</text>\n",
            0.5 * (top_ + bottom_), escaped(plot_.y_label));
        text("tp-quiet", 0.5 * (kLeft + kWidth - kRight), bottom_ + 42 + kLineHeight, "middle", plot_.note);
    }

    void noise(const LogAxis& y) {
        const double at = y.at(plot_.noise_floor);
        out_ += fmt::format(
            "<rect class=\"tp-noise\" x=\"{}\" y=\"{:.1f}\" width=\"{}\" height=\"{:.1f}\"><title>The reference's own "
            "noise: {:.2g}</title></rect>\n",
            kLeft, at, kWidth - kRight - kLeft, bottom_ - at, plot_.noise_floor);
        line("tp-floor", kLeft, at, kWidth - kRight, at);
        text("tp-quiet tp-small", kWidth - kRight - 8, at + 14, "end", "noise of the reference");
    }

    void front(const LogAxis& x, const LogAxis& y) {
        std::vector<Outcome> outcomes;
        for (const PlotSeries& series : plot_.series)
            for (const PlotPoint& point : series.points)
                if (drawable(point)) outcomes.push_back({point.x, point.y});
        double last = top_;
        std::string path;
        for (const size_t i : pareto_front(outcomes)) {
            const double px = x.at(outcomes[i].cost), py = y.at(outcomes[i].error);
            path += path.empty() ? fmt::format("M{:.1f} {:.1f}", px, last) : fmt::format("H{:.1f}", px);
            path += fmt::format("V{:.1f}", py);
            last = py;
        }
        out_ += fmt::format("<path class=\"tp-front\" d=\"{}H{}\"><title>Pareto front</title></path>\n", path,
                            kWidth - kRight);
    }

    void markers(const LogAxis& x, const LogAxis& y) {
        Labels labels({kLeft + 2, top_ + 2, kWidth - kRight - 2, bottom_ - 2});
        std::string points;
        for (size_t s = 0; s < plot_.series.size(); ++s) {
            const PlotSeries& series = plot_.series[s];
            std::string joined;
            for (const PlotPoint& point : series.points) {
                if (!drawable(point)) continue;
                const double px = x.at(point.x), py = y.at(point.y);
                joined += fmt::format("{}{:.1f} {:.1f}", joined.empty() ? "M" : "L", px, py);
                points += fmt::format("<g class=\"tp-s{}{}\"><title>{}</title>{}</g>\n", s % kSeriesColours,
                                      point.within_noise ? " tp-hollow" : "", escaped(point.title), marker(s, px, py));
                labels.occupy(px, py);
            }
            if (series.joined && series.points.size() > 1)
                out_ += fmt::format("<path class=\"tp-s{} tp-join\" d=\"{}\"/>\n", s % kSeriesColours, joined);
        }
        out_ += points;
        for (size_t s = 0; s < plot_.series.size(); ++s)
            for (const PlotPoint& point : plot_.series[s].points)
                if (drawable(point)) out_ += labels.place(s, x.at(point.x), y.at(point.y), point.label);
    }

    void line(const char* style, double x0, double y0, double x1, double y1) {
        out_ += fmt::format("<line class=\"{}\" x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\"/>\n", style, x0,
                            y0, x1, y1);
    }
    void text(const char* style, double x, double y, const char* anchor, const std::string& what) {
        if (!what.empty())
            out_ += fmt::format("<text class=\"{}\" x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\">{}</text>\n", style, x,
                                y, anchor, escaped(what));
    }

    const Plot& plot_;
    Legend legend_;
    double top_ = 0, bottom_ = 0, height_ = 0;
    Range x_, y_;
    bool floor_shown_ = false;
    std::string out_;
};

}  // namespace

std::string svg_of(const Plot& plot) {
    return Drawing(plot).all();
}

}  // namespace tyndall::measure
