#include "measure/log_axis.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace tyndall::measure {
namespace {

constexpr double kRoom = 0.06;      // of the length, on each side
constexpr double kLeastSpan = 0.5;  // decades

/// Whether this mark has a label: the fewer decades, the more.
bool labelled(int mantissa, double span) {
    if (mantissa == 1) return true;
    if (span < 0.8) return true;
    return span < 1.8 && (mantissa == 2 || mantissa == 5);
}

}  // namespace

LogAxis::LogAxis(double low, double high, double from, double to)
    : low_(std::log10(low)), high_(std::log10(high)), from_(from), to_(to) {
    const double missing = std::max(0.0, kLeastSpan - (high_ - low_));
    const double room = kRoom * std::max(high_ - low_, kLeastSpan) + 0.5 * missing;
    low_ -= room;
    high_ += room;
}

double LogAxis::at(double value) const {
    return from_ + (std::log10(value) - low_) / (high_ - low_) * (to_ - from_);
}

std::vector<Tick> LogAxis::ticks() const {
    std::vector<Tick> all;
    const double span = high_ - low_;
    for (int exponent = static_cast<int>(std::floor(low_)); exponent <= static_cast<int>(std::ceil(high_)); ++exponent)
        for (int mantissa = 1; mantissa < 10; ++mantissa) {
            const double decimal = exponent + std::log10(mantissa);
            if (decimal < low_ || decimal > high_) continue;
            all.push_back({from_ + (decimal - low_) / span * (to_ - from_),
                           labelled(mantissa, span) ? tick_text(mantissa, exponent) : ""});
        }
    return all;
}

std::string tick_text(int mantissa, int exponent) {
    if (exponent >= -2 && exponent <= 4) return fmt::format("{:g}", mantissa * std::pow(10.0, exponent));
    constexpr const char* kRaised[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
    std::string text = mantissa == 1 ? "10" : fmt::format("{}·10", mantissa);
    if (exponent < 0) text += "⁻";
    for (const char digit : fmt::format("{}", std::abs(exponent))) text += kRaised[digit - '0'];
    return text;
}

}  // namespace tyndall::measure
