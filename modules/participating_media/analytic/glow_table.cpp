#include "analytic/glow_table.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "physics/physics.h"
#include "quadrature.h"

namespace tyndall::participating_media {
namespace {

constexpr int kGammas = 64, kTurns = 24;

/// Integral of max(0, a + b cos phi) over a whole turn, b >= 0.
double clamped_turn(double a, double b) {
    if (a >= b) return 2.0 * std::numbers::pi * a;
    if (a <= -b) return 0.0;
    const double open = std::acos(-a / b);
    return 2.0 * (a * open + b * std::sin(open));
}

/// Integral over a turn of the normalised Phong lobe about a direction at `angle` from the lamp.
double lobe_turn(double angle, double gamma, double exponent) {
    double sum = 0.0;
    for (int i = 0; i < kTurns; ++i) {
        const double phi = std::numbers::pi * (i + 0.5) / kTurns;
        const double cosine = std::cos(angle) * std::cos(gamma) + std::sin(angle) * std::sin(gamma) * std::cos(phi);
        if (cosine > 0.0) sum += std::pow(cosine, exponent);
    }
    return sum / kTurns * (exponent + 1.0);
}

double weight(int layer, double angle, double gamma) {
    if (layer == 0) return clamped_turn(std::cos(angle) * std::cos(gamma), std::sin(angle) * std::sin(gamma));
    const double share = double(layer - 1) / (GlowTable::kLayers - 2);
    return lobe_turn(angle, gamma, phong_exponent(std::lerp(double(GlowTable::kLeastRoughness), 1.0, share)));
}

}  // namespace

double phong_exponent(double roughness) {
    const double alpha = roughness * roughness;
    return (2.0 / (alpha * alpha) - 2.0) / 4.0;
}

GlowTable make_glow_table() {
    const std::vector<glm::vec2> nodes = gauss_legendre(kGammas);
    std::vector<double> gammas, around;  // around: [distance][gamma], with the nodes' weights and exp(T)
    for (const glm::vec2 node : nodes) gammas.push_back(0.5 * std::numbers::pi * (1.0 + double(node.x)));
    for (int i = 0; i < GlowTable::kDistances; ++i) {
        const float share = static_cast<float>(i) / (GlowTable::kDistances - 1);
        const float depth = GlowTable::kLeastDepth * std::pow(GlowTable::kMostDepth / GlowTable::kLeastDepth, share);
        for (size_t j = 0; j < nodes.size(); ++j)
            around.push_back(double(physics::airlight_around(depth, static_cast<float>(gammas[j]))) *
                             std::exp(double(depth)) * 0.5 * std::numbers::pi * double(nodes[j].y));
    }
    GlowTable table;
    std::vector<double> weights(nodes.size());
    for (int layer = 0; layer < GlowTable::kLayers; ++layer)
        for (int angle = 0; angle < GlowTable::kAngles; ++angle) {
            const double theta = std::numbers::pi * angle / (GlowTable::kAngles - 1);
            for (size_t j = 0; j < nodes.size(); ++j) weights[j] = weight(layer, theta, gammas[j]);
            for (size_t i = 0; i < size_t{GlowTable::kDistances}; ++i) {
                double sum = 0.0;
                for (size_t j = 0; j < nodes.size(); ++j) sum += weights[j] * around[i * nodes.size() + j];
                table.values.push_back(static_cast<float>(sum));
            }
        }
    return table;
}

}  // namespace tyndall::participating_media
