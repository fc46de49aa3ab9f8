#pragma once
/// A logarithmic axis: what stands where, and where its marks are.

#include <string>
#include <vector>

namespace tyndall::measure {

/// A mark of an axis.
struct Tick {
    double at = 0;      ///< pixels
    std::string label;  ///< empty: a line alone
};

/// From `low` to `high`, with some room on both sides, over the pixels from `from` to `to`.
class LogAxis {
 public:
    LogAxis(double low, double high, double from, double to);

    [[nodiscard]] double at(double value) const;
    [[nodiscard]] std::vector<Tick> ticks() const;

 private:
    double low_, high_;  ///< decimal logarithms
    double from_, to_;
};

/// "0.05", "20", "10⁻⁴", "5·10⁻⁵".
[[nodiscard]] std::string tick_text(int mantissa, int exponent);

}  // namespace tyndall::measure
