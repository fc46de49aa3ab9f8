#include "report/entry.h"

#include <algorithm>
#include <utility>

namespace tyndall::report {
namespace {

constexpr float kFullZ = 6;  // |z| that is drawn brightest

void add_map(Entry& entry, const char* name, const char* label, Image values, float full) {
    if (!values.empty()) entry.maps.push_back({name, label, std::move(values), full});
}

}  // namespace

Comparison compare(Entry& entry, const ComparisonOptions& options, const Image& reference_variance,
                   const Image& test_variance) {
    Comparison found = compare_pictures({entry.reference, reference_variance}, {entry.test, test_variance}, options);
    entry.reference = fitted_to(entry.reference, entry.reference);
    entry.test = found.test;
    entry.metrics = found.metrics;
    entry.exposure = found.exposure;
    entry.notes.insert(entry.notes.end(), found.notes.begin(), found.notes.end());
    entry.worst.clear();
    for (const Block& block : found.worst) entry.worst.emplace_back(block.x, block.y);
    add_map(entry, "hdr_flip", "HDR-FLIP", found.hdr_flip, 1);
    add_map(entry, "flip", "FLIP", found.flip, 1);
    Image dissimilar = found.ssim;
    if (!dissimilar.empty())
        for (float& v : dissimilar.floats()) v = 1 - v;
    add_map(entry, "ssim", "1 - SSIM", std::move(dissimilar), 1);
    add_map(entry, "z", "|z| of 8x8 blocks", found.z, kFullZ);
    entry.held = entry.held && found.finite;
    return found;
}

bool hold(Entry& entry, const std::string& name, double limit, const std::string& reason) {
    const Metric& metric = metric_called(name);
    Comparison found;
    found.metrics = entry.metrics;
    const auto broken = entry.metrics.find("not_finite");
    found.finite = broken == entry.metrics.end() || broken->second == 0;
    const bool held = holds(found, metric, limit);
    entry.limits.push_back({name, limit, metric.at_least, held, reason});
    entry.held = entry.held && held;
    return held;
}

}  // namespace tyndall::report
