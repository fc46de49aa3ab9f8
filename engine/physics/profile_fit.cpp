#include "physics/profile_fit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/exponential.hpp>
#include <limits>
#include <numbers>
#include <span>

#include "physics/non_negative.h"

namespace tyndall::physics {
namespace {

constexpr int kMostLobes = 16;
constexpr double kTotalCounts = 30.0;  ///< how much an error of the weights' sum counts against the rest

/// What a fit is asked for at one place, a channel each.
struct Sample {
    double at = 0.0;  ///< m
    bool edge = false;
    glm::dvec3 wanted{0.0}, scale{0.0};
};

/// A Gaussian of variance 1 there, m: exitance at a distance, or share beyond an edge.
double lobe_at(const Sample& sample, double variance) {
    if (sample.edge) return 0.5 * std::erfc(sample.at / std::sqrt(2.0 * variance));
    return std::exp(-sample.at * sample.at / (2.0 * variance)) / (2.0 * std::numbers::pi * variance);
}

/// How far the light of a channel goes; the places of samples follow from it.
double scale_of(const RadialProfile& wanted, int channel) {
    return std::max(wanted.distance(0.5, channel), 1e-7);
}

/// The profile by area along r, and the edge's dark side (its lit one mirrors it), each with a mean square of 1.
std::vector<Sample> samples_of(const RadialProfile& wanted) {
    std::vector<Sample> samples;
    glm::dvec3 area(0.0);
    for (const RadialProfile::Ring& ring : wanted.rings()) {
        const glm::dvec3 value = ring.r * ring.exitance;
        area += ring.r * value * value;
    }
    for (const RadialProfile::Ring& ring : wanted.rings())
        samples.push_back({ring.r, false, ring.exitance, std::sqrt(ring.r) * ring.r / glm::sqrt(area)});
    const size_t rings = samples.size();
    glm::dvec3 edges(0.0);
    for (size_t i = 0; i < rings; i += 4) {
        const double x = samples[i].at;
        const glm::dvec3 value = glm::dvec3(1.0) - wanted.edge(x);
        samples.push_back({x, true, value, glm::dvec3(std::sqrt(x))});
        edges += x * value * value;
    }
    for (size_t i = rings; i < samples.size(); ++i) samples[i].scale *= 12.0 / glm::sqrt(edges);
    return samples;
}

/// Lobes of the given range and what they leave over.
struct Attempt {
    std::vector<double> variances;
    std::array<std::vector<double>, 3> weights;
    double left = std::numeric_limits<double>::infinity();
};

Attempt attempt(const std::vector<Sample>& samples, double first, double last, int lobes, int sweeps) {
    Attempt result;
    for (int k = 0; k < lobes; ++k)
        result.variances.push_back(first * std::pow(last / first, lobes > 1 ? double(k) / (lobes - 1) : 0.0));
    std::vector<NonNegativeEquations> equations(3, NonNegativeEquations(size_t(lobes)));
    std::array<double, kMostLobes> values{};
    const std::span<double> basis = std::span(values).first(size_t(lobes));
    for (const Sample& sample : samples) {
        for (size_t k = 0; k < basis.size(); ++k) basis[k] = lobe_at(sample, result.variances[k]);
        for (int c = 0; c < 3; ++c) equations[size_t(c)].add(basis, sample.wanted[c], sample.scale[c]);
    }
    std::ranges::fill(basis, 1.0);
    result.left = 0.0;
    for (size_t c = 0; c < 3; ++c) {
        equations[c].add(basis, 1.0, kTotalCounts);
        result.weights[c] = equations[c].solve(sweeps);
        result.left += equations[c].error(result.weights[c]);
    }
    return result;
}

/// Walks over narrowest and widest variance, in ever smaller steps.
Attempt search(const std::vector<Sample>& samples, double narrow, double wide, int lobes) {
    constexpr int kQuick = 400, kThorough = 20000;
    double first = narrow, last = wide;
    Attempt best = attempt(samples, first, last, lobes, kQuick);
    for (double step = 4.0; step > 1.05;) {
        bool moved = false;
        for (const auto& [a, b] : {std::pair(step, 1.0), {1.0 / step, 1.0}, {1.0, step}, {1.0, 1.0 / step}}) {
            if (lobes > 1 && first * a * 1.5 > last * b) continue;
            Attempt next = attempt(samples, first * a, last * b, lobes, kQuick);
            if (next.left >= best.left) continue;
            best = std::move(next);
            first *= a;
            last *= b;
            moved = true;
            break;
        }
        if (!moved) step = std::sqrt(step);
    }
    return attempt(samples, first, last, lobes, kThorough);
}

glm::dvec3 radial_error(const RadialProfile& wanted, const DiffusionProfile& fitted) {
    glm::dvec3 wrong(0.0), all(0.0);
    for (const RadialProfile::Ring& ring : wanted.rings()) {
        const glm::dvec3 off = ring.r * (glm::dvec3(fitted.at(float(ring.r))) - ring.exitance);
        wrong += ring.r * off * off;
        all += ring.r * (ring.r * ring.exitance) * (ring.r * ring.exitance);
    }
    return glm::sqrt(wrong / all);
}

glm::dvec3 edge_rms(const RadialProfile& wanted, const DiffusionProfile& fitted) {
    constexpr int kPlaces = 400;
    glm::dvec3 result(0.0);
    for (int c = 0; c < 3; ++c) {
        double far = scale_of(wanted, c);
        while (wanted.edge(far)[c] < 0.995) far *= 1.1;
        double sum = 0.0;
        for (int i = 0; i < kPlaces; ++i) {
            const double x = far * (i + 0.5) / kPlaces;
            const double off = double(fitted.edge(float(x))[c]) - wanted.edge(x)[c];
            sum += off * off;
        }
        result[c] = std::sqrt(sum / kPlaces);
    }
    return result;
}

}  // namespace

ProfileFit fit_profile(const RadialProfile& wanted, int lobes) {
    ProfileFit fit;
    fit.total = wanted.total();
    if (wanted.rings().empty()) return fit;
    double narrow = std::numeric_limits<double>::infinity(), wide = 0.0;
    for (int c = 0; c < 3; ++c) {
        const double near = wanted.distance(0.1, c), far = wanted.distance(0.97, c);
        narrow = std::min(narrow, near * near);
        wide = std::max(wide, 0.25 * far * far);
    }
    const std::vector<Sample> samples = samples_of(wanted);
    Attempt best;
    for (const double start : {narrow, 0.1 * narrow}) {  // the search may end in a dip that is not the deepest
        Attempt next = search(samples, start, wide, std::clamp(lobes, 1, kMostLobes));
        if (next.left < best.left) best = std::move(next);
    }
    for (size_t k = 0; k < best.variances.size(); ++k) {
        const glm::vec3 weight(best.weights[0][k], best.weights[1][k], best.weights[2][k]);
        if (weight != glm::vec3(0.0f)) fit.profile.lobes.push_back({float(best.variances[k]), weight});
    }
    fit.profile.normalise();
    fit.error = radial_error(wanted, fit.profile);
    fit.edge_error = edge_rms(wanted, fit.profile);
    return fit;
}

}  // namespace tyndall::physics
