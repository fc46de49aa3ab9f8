#pragma once
/// Filling a report's entries.

#include "image/comparison.h"
#include "report/report.h"

namespace tyndall::report {

/// Compares the entry's pictures (of which the test may be a whole multiple of the reference's size) and fills in its
/// metrics, maps, worst blocks, notes and exposure; `held` becomes false when the test is not finite. Variances may be
/// empty: see compare_pictures. Returns what was found; throws Error as compare_pictures does.
Comparison compare(Entry& entry, const ComparisonOptions& options = {}, const Image& reference_variance = {},
                   const Image& test_variance = {});

/// Holds one metric of a compared entry against a limit: adds to its limits, and `held` becomes false when it is not
/// within. Throws Error for an unknown metric.
bool hold(Entry& entry, const std::string& metric, double limit, const std::string& reason = {});

}  // namespace tyndall::report
