#pragma once
/// Which of many are best, when two things count.

#include <cstddef>
#include <span>
#include <vector>

namespace tyndall::measure {

/// What a run costs and what it leaves wrong; less of either is better.
struct Outcome {
    double cost = 0;
    double error = 0;
};

/// The indices of the outcomes that no other beats (at most the cost and at most the error, and less of one), by rising
/// cost; of equals the first. Outcomes that are not finite are left out.
[[nodiscard]] std::vector<size_t> pareto_front(std::span<const Outcome> outcomes);

}  // namespace tyndall::measure
