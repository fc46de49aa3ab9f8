// Light that fog around a lamp sends onto surfaces: the table against the volume integral that it stands for.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <numbers>

#include "analytic/glow_table.h"

namespace tyndall::participating_media {
namespace {

constexpr double kPi = std::numbers::pi;

/// What a point receives, one metre from a lamp of 1 cd in fog that scatters `depth` per metre: every piece of the
/// volume, weighed by `weight` of the cosine to a direction at `angle` from the lamp. Polar coordinates about the way
/// to the lamp, along each ray at equal angles seen from the lamp; shares nothing with the table but what both mean.
double by_volume(double depth, double angle, const std::function<double(double)>& weight) {
    constexpr int kSteps = 300, kGammas = 300, kPhis = 48;
    double sum = 0.0;
    for (int i = 0; i < kGammas; ++i) {
        const double s = (i + 0.5) / kGammas, gamma = kPi * s * s;  // crowded about the lamp
        double turn = 0.0;
        for (int k = 0; k < kPhis; ++k)
            turn += weight(std::cos(angle) * std::cos(gamma) +
                           std::sin(angle) * std::sin(gamma) * std::cos(2.0 * kPi * (k + 0.5) / kPhis));
        const double closest = std::cos(gamma), passing = std::max(std::sin(gamma), 1e-6);
        const double from = std::atan(-closest / passing), step = (0.5 * kPi - from) / kSteps;
        double ray = 0.0;
        for (int j = 0; j < kSteps; ++j) {
            const double at = from + (j + 0.5) * step, t = closest + passing * std::tan(at);
            ray += std::exp(-depth * (t + passing / std::cos(at))) * step / passing;  // dt / d^2 = dangle / passing
        }
        sum += ray * depth / (4.0 * kPi) * turn * (2.0 * kPi / kPhis) * std::sin(gamma) * 2.0 * kPi * s / kGammas;
    }
    return sum;
}

double depth_of(int distance) {
    return double(GlowTable::kLeastDepth) * std::pow(double(GlowTable::kMostDepth / GlowTable::kLeastDepth),
                                                     double(distance) / (GlowTable::kDistances - 1));
}

/// Worst relative error of a layer, over thin and thick fog and all around.
double worst_error(const GlowTable& table, int layer, const std::function<double(double)>& weight) {
    double worst = 0.0;
    for (const int distance : {12, 28, 40, 52})
        for (const int angle : {0, 8, 16, 24, 31}) {
            const double depth = depth_of(distance);
            const double truth = by_volume(depth, kPi * angle / (GlowTable::kAngles - 1), weight);
            const double found = double(table.at(layer, angle, distance)) * std::exp(-depth) * depth;
            worst = std::max(worst, std::abs(found / truth - 1.0));
        }
    return worst;
}

TEST(SurfaceGlow, IrradianceIsTheVolumeIntegral) {
    const double worst = worst_error(make_glow_table(), 0, [](double cosine) { return std::max(cosine, 0.0); });
    std::printf("irradiance: worst relative error %.5f\n", worst);
    EXPECT_LT(worst, 0.005);
}

TEST(SurfaceGlow, LobesAreTheVolumeIntegral) {
    const GlowTable table = make_glow_table();
    for (const int layer : {2, 4, 6}) {  // the first is 48 times as narrow as the integral's steps about it
        const double roughness = std::lerp(double(GlowTable::kLeastRoughness), 1.0, double(layer - 1) / 5.0);
        const double exponent = phong_exponent(roughness);
        const double worst = worst_error(table, layer, [&](double cosine) {
            return cosine > 0.0 ? (exponent + 1.0) / (2.0 * kPi) * std::pow(cosine, exponent) : 0.0;
        });
        std::printf("roughness %.2f: worst relative error %.5f\n", roughness, worst);
        EXPECT_LT(worst, 0.02);
    }
}

}  // namespace
}  // namespace tyndall::participating_media
