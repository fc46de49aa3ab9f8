#include "physics/hankel.h"

#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <numbers>
#include <vector>

namespace tyndall::physics {
namespace {

/// A place x = k r and what F counts there.
struct Node {
    double x = 0.0, weight = 0.0;
};

constexpr double kBlur = 0.04;  ///< the narrower Gaussian's width over r

void add_panel(std::vector<Node>& nodes, double from, double to) {
    using Rule = boost::math::quadrature::gauss<double, 7>;
    const auto add = [&](double t, double weight) {
        const double x = 0.5 * (from + to) + 0.5 * (to - from) * t, fade = std::exp(-0.5 * kBlur * kBlur * x * x);
        // blurred with variances b and 2 b, R is off by c b and 2 c b
        nodes.push_back({x, 0.5 * (to - from) * weight * x * j0(x) * (2.0 * fade - fade * fade)});
    };
    for (size_t i = 0; i < Rule::abscissa().size(); ++i) {
        add(Rule::abscissa()[i], Rule::weights()[i]);
        if (Rule::abscissa()[i] != 0.0) add(-Rule::abscissa()[i], Rule::weights()[i]);
    }
}

/// Panels that grow from 0, as F may have its whole fall there, then one for each half turn of J0.
std::vector<Node> make_nodes() {
    std::vector<Node> nodes;
    double low = 0.0;
    for (double high = 1e-4; high < 2.0; high *= 2.0) {
        add_panel(nodes, low, high);
        low = high;
    }
    for (; low < 6.5 / kBlur; low += std::numbers::pi) add_panel(nodes, low, low + std::numbers::pi);
    return nodes;
}

}  // namespace

glm::dvec3 inverse_hankel(const FrequencyFunction& f, double r) {
    static const std::vector<Node> kNodes = make_nodes();
    glm::dvec3 sum(0.0);
    for (const Node& node : kNodes) sum += node.weight * f(node.x / r);
    return sum / (2.0 * std::numbers::pi * r * r);
}

}  // namespace tyndall::physics
