#include "physics/radial_profile.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/vector_relational.hpp>
#include <numbers>

namespace tyndall::physics {
namespace {

constexpr double kFirst = 1e-7, kLast = 10.0;  ///< m
constexpr int kPerDecade = 40;

/// Whether so little leaves in a ring that no more is to come.
bool is_past(const glm::dvec3& share, const glm::dvec3& total) {
    return glm::all(glm::greaterThan(total, glm::dvec3(0.0))) && glm::all(glm::lessThan(share, 1e-9 * total));
}

}  // namespace

double RadialProfile::step() {
    return std::numbers::ln10 / kPerDecade;
}

RadialProfile::RadialProfile(const RadialFunction& exitance) {
    const int count = int(std::lround(std::log10(kLast / kFirst) * kPerDecade));
    for (int i = 0; i < count; ++i) {
        Ring ring{kFirst * std::exp((i + 0.5) * step())};
        const glm::dvec3 found = exitance(ring.r);
        for (int c = 0; c < 3; ++c) ring.exitance[c] = std::isfinite(found[c]) ? std::max(found[c], 0.0) : 0.0;
        ring.share = 2.0 * std::numbers::pi * ring.r * ring.r * step() * ring.exitance;
        total_ += ring.share;
        rings_.push_back(ring);
        if (is_past(ring.share, total_)) break;
    }
    const glm::dvec3 scale = 1.0 / glm::max(total_, glm::dvec3(1e-300));
    for (Ring& ring : rings_) {
        ring.exitance *= scale;
        ring.share *= scale;
    }
    std::erase_if(rings_, [](const Ring& ring) { return std::max({ring.share.x, ring.share.y, ring.share.z}) < 1e-9; });
}

/// Of each ring, the part whose distance across the edge is shorter than x.
glm::dvec3 RadialProfile::edge(double x) const {
    glm::dvec3 sum(0.5);
    for (const Ring& ring : rings_)
        sum += ring.share * (std::asin(std::clamp(x / ring.r, -1.0, 1.0)) / std::numbers::pi);
    return sum;
}

double RadialProfile::distance(double share, int channel) const {
    double sum = 0.0;
    for (const Ring& ring : rings_) {
        sum += ring.share[channel];
        if (sum >= share) return ring.r;
    }
    return rings_.empty() ? 0.0 : rings_.back().r;
}

glm::dvec3 RadialProfile::mean_distance() const {
    glm::dvec3 sum(0.0);
    for (const Ring& ring : rings_) sum += ring.share * ring.r;
    return sum;
}

double edge_width(const std::function<double(double)>& edge) {
    double low = 0.0, high = 1e-7;  // the edge is symmetric: 90 % lies as far inside as 10 % outside
    while (edge(high) < 0.9 && high < 100.0) high *= 2.0;
    for (int i = 0; i < 40; ++i) {
        const double middle = 0.5 * (low + high);
        (edge(middle) < 0.9 ? low : high) = middle;
    }
    return low + high;
}

}  // namespace tyndall::physics
