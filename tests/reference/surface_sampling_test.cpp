// Surfaces: samplers follow their densities, and light may go either way.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "chi_square.h"
#include "reference/rough_boundary.h"
#include "reference/standard_bsdf.h"
#include "scenes.h"

namespace tyndall::reference {
namespace {

using glm::vec3;

const vec3 kNormal(0.0f, 0.0f, 1.0f);

const GgxAlbedo& albedo_table() {
    static const GgxAlbedo table;
    return table;
}

struct Layered {
    const char* name;
    float roughness, metallic;
    vec3 base;
    float through = 0.0f;
    vec3 through_colour{1.0f};
};
const Layered kLayered[] = {{"coated, roughness 0.3", 0.3f, 0.0f, vec3(0.8f, 0.5f, 0.1f)},
                            {"coated, roughness 0.9", 0.9f, 0.0f, vec3(0.2f, 0.5f, 0.9f)},
                            {"metal, roughness 0.4", 0.4f, 1.0f, vec3(0.9f, 0.6f, 0.3f)},
                            {"half metal, roughness 0.6", 0.6f, 0.5f, vec3(0.7f)},
                            {"leaf, roughness 0.4", 0.4f, 0.0f, vec3(0.1f, 0.4f, 0.05f), 0.6f, vec3(0.5f, 0.9f, 0.2f)}};

MaterialPoint point_of(const Layered& layered) {
    MaterialPoint point;
    point.roughness = layered.roughness, point.metallic = layered.metallic, point.base_colour = layered.base;
    point.diffuse_transmission = layered.through, point.diffuse_transmission_colour = layered.through_colour;
    return point;
}

vec3 tilted(float degrees, float azimuth = 0.7f) {
    return physics::spherical_direction(std::cos(glm::radians(degrees)), azimuth);
}

TEST(Samplers, StandardMaterial) {
    constexpr int kSamples = 400000;
    uint32_t seed = 400;
    for (const Layered& layered : kLayered)
        for (const float angle : {10.0f, 65.0f}) {
            const bool both_sides = layered.through > 0.0f;
            const DirectionBins bins{both_sides ? 48 : 24, 32, both_sides ? -1.0f : 0.0f};
            const StandardBsdf bsdf(point_of(layered), &albedo_table(), kNormal, tilted(angle));
            glm::dvec3 light(0.0), weights(0.0);
            const double share = bins.solid_angle() / (24.0 * 24.0);
            std::vector<double> expected = bins.integrals(24, [&](const vec3& l) {
                float pdf = 0.0f;
                light += share * glm::dvec3(bsdf.evaluate(l, pdf));
                return static_cast<double>(pdf);
            });
            double above = 0.0;
            for (double& value : expected) above += value, value *= kSamples;
            expected.push_back((1.0 - above) * kSamples);  // directions that go into the surface
            std::vector<double> observed(expected.size());
            Dice dice(++seed);
            for (int i = 0; i < kSamples; ++i) {
                BsdfSample sample;
                const float lobe = dice(), x = dice();
                if (bsdf.sample(lobe, {x, dice()}, sample)) {
                    ++observed[bins.of(sample.direction)];
                    weights += glm::dvec3(sample.weight) / static_cast<double>(kSamples);
                } else {
                    ++observed.back();
                }
            }
            expect_distribution(fmt::format("{}, seen at {} degrees", layered.name, angle), expected, observed);
            for (int c = 0; c < 3; ++c) EXPECT_NEAR(weights[c] / light[c], 1.0, 0.01) << "mean weight, channel " << c;
        }
}

TEST(Layers, WhiteOnesReturnAllLight) {
    // The mean weight of samples is the albedo; here they are Roberts' additive sequence, which fills a cube evenly.
    constexpr int kPoints = 200000;
    constexpr double kRoot = 1.2207440846057596;  // of x^4 = x + 1
    double worst = 0.0;
    constexpr glm::vec2 kKinds[] = {{0.0f, 0.0f}, {0.0f, 0.4f}, {0.0f, 1.0f}, {1.0f, 0.0f}};
    for (const auto& [metallic, through] : kKinds)
        for (const float roughness : {0.1f, 0.3f, 0.6f, 1.0f})
            for (const float angle : {0.0f, 45.0f, 75.0f, 85.0f}) {
                const StandardBsdf bsdf(point_of({"", roughness, metallic, vec3(1.0f), through}), &albedo_table(),
                                        kNormal, tilted(angle));
                glm::dvec3 at(0.5);
                double sum = 0.0;
                for (int i = 0; i < kPoints; ++i) {
                    at = glm::fract(at + 1.0 / glm::dvec3(kRoot, kRoot * kRoot, kRoot * kRoot * kRoot));
                    BsdfSample sample;
                    if (bsdf.sample(static_cast<float>(at.x), {at.y, at.z}, sample))
                        sum += static_cast<double>(sample.weight.x);
                }
                worst = std::max(worst, std::abs(sum / kPoints - 1.0));
            }
    expect_below("white layers, coated, leaves and metal: |albedo - 1|", worst, 0.0015);
}

TEST(Reciprocity, StandardMaterial) {
    Dice dice(500);
    double worst = 0.0;
    for (const Layered& layered : kLayered)
        for (int i = 0; i < 20000; ++i) {
            const float a = dice(), b = dice(), c = dice();
            const vec3 v = physics::spherical_direction(0.02f + 0.98f * a, physics::kTwoPi * b);
            const float side = layered.through > 0.0f && i % 2 == 1 ? -1.0f : 1.0f;  // of l
            const vec3 l = physics::spherical_direction(side * (0.02f + 0.98f * c), physics::kTwoPi * dice());
            float pdf = 0.0f;
            const MaterialPoint point = point_of(layered);
            const vec3 to = StandardBsdf(point, &albedo_table(), kNormal, v).evaluate(l, pdf) / std::abs(l.z);
            const vec3 fro = StandardBsdf(point, &albedo_table(), side * kNormal, l).evaluate(v, pdf) / v.z;
            EXPECT_GT(to.x + to.y + to.z, 0.0f);
            for (int k = 0; k < 3; ++k)
                worst = std::max(worst, static_cast<double>(std::abs(to[k] - fro[k]) / std::max(to[k], 1e-6f)));
        }
    expect_below("standard material: |f(l, v) / f(v, l) - 1|", worst, 1e-4);
}

/// Mean and variance of the mean of evaluations.
struct Estimate {
    double mean = 0.0, variance = 0.0;
};
template <class Draw>
Estimate estimate(int count, Draw draw) {
    double sum = 0.0, squares = 0.0;
    for (int i = 0; i < count; ++i) {
        const double value = draw(i);
        sum += value, squares += value * value;
    }
    const double mean = sum / count;
    return {mean, std::max(0.0, squares / count - mean * mean) / (count - 1)};
}

/// f(l, v), of one direction on each side or both on one; `n` is on the side of `v`. Few walks turn toward `l` by many
/// bounces, and bring much: it takes many evaluations until their sum is normal.
Estimate rough_f(const vec3& n, const vec3& v, const vec3& l, float eta, float roughness, uint32_t seed) {
    return estimate(100000, [&](int i) {
        Sampler sampler(glm::uvec2(seed, 1), 600, 0, static_cast<uint32_t>(i));
        float pdf = 0.0f;
        return static_cast<double>(RoughBoundary(n, v, eta, roughness, sampler).evaluate(l, pdf) / std::abs(l.z));
    });
}

TEST(Reciprocity, RoughBoundary) {
    // Radiance over the index squared is what keeps its value across a boundary: f(l, v) / n_v^2 = f(v, l) / n_l^2.
    Dice dice(601);
    double squares = 0.0, worst = 0.0, sums[2] = {};
    int count = 0;
    for (const float eta : {1.5f, 1.0f / 1.33f})
        for (const float roughness : {0.5f, 0.9f})
            for (int i = 0; i < 10; ++i) {
                const float a = dice(), b = dice(), c = dice();
                const bool across = i % 2 == 1;
                const vec3 v = physics::spherical_direction(0.2f + 0.75f * a, physics::kTwoPi * b);
                const vec3 l = physics::spherical_direction((across ? -1.0f : 1.0f) * (0.2f + 0.75f * c),
                                                            physics::kTwoPi * dice());
                const auto seed = static_cast<uint32_t>(2 * count);
                const Estimate to = rough_f(kNormal, v, l, eta, roughness, seed);
                const Estimate fro =
                    rough_f(across ? -kNormal : kNormal, l, v, across ? 1.0f / eta : eta, roughness, seed + 1);
                const double scale = across ? static_cast<double>(eta * eta) : 1.0;
                const double z = (scale * to.mean - fro.mean) / std::sqrt(scale * scale * to.variance + fro.variance);
                sums[0] += scale * to.mean, sums[1] += fro.mean;
                squares += z * z, worst = std::max(worst, std::abs(z)), ++count;
            }
    const double p = chi_square_tail(squares, count);
    fmt::print(
        "rough boundary, reciprocity: {} pairs, chi-square p {:.3f} (limit {}), largest |z| {:.2f}; sums {:.4f} and "
        "{:.4f}\n",
        count, p, kSignificance, worst, sums[0], sums[1]);
    EXPECT_GT(p, kSignificance);
    EXPECT_NEAR(sums[0] / sums[1], 1.0, 0.02);
}

/// Share of the walks that end in a bin: the mean of f |cos| over it, without the change of radiance across.
Estimate share_of(const DirectionBins& bins, size_t bin, const vec3& v, float eta, float roughness, Dice& dice) {
    return estimate(20000, [&](int i) {
        Sampler sampler(glm::uvec2(701, bin), 700, 1, static_cast<uint32_t>(i));
        const float x = dice();
        const vec3 l = bins.direction(bin, x, dice());
        float pdf = 0.0f;
        const float value = RoughBoundary(kNormal, v, eta, roughness, sampler).evaluate(l, pdf);
        return static_cast<double>(l.z > 0.0f ? value : value * eta * eta) * bins.solid_angle();
    });
}

TEST(Samplers, RoughBoundary) {
    // Its density is not known in closed form: the walks' directions are held against estimates of f |cos|.
    constexpr int kSamples = 200000;
    const DirectionBins bins{10, 8, -1.0f};
    Dice dice(701);
    for (const float eta : {1.5f, 1.0f / 1.5f})
        for (const float roughness : {0.5f, 0.9f}) {
            const vec3 v = tilted(40.0f);
            std::vector<double> observed(bins.count());
            for (uint32_t i = 0; i < kSamples; ++i) {
                Sampler sampler(glm::uvec2(700), 700, 0, i);
                BsdfSample sample;
                if (RoughBoundary(kNormal, v, eta, roughness, sampler).sample(sample))
                    ++observed[bins.of(sample.direction)];
            }
            double squares = 0.0, total = 0.0, variance = 0.0;
            int used = 0;
            for (size_t bin = 0; bin < bins.count(); ++bin) {
                const Estimate share = share_of(bins, bin, v, eta, roughness, dice);
                total += share.mean, variance += share.variance;
                if (share.mean * kSamples < 10.0) continue;
                const double off = observed[bin] / kSamples - share.mean;
                squares += off * off / (share.mean / kSamples + share.variance);
                ++used;
            }
            const double p = chi_square_tail(squares, used);
            fmt::print(
                "rough boundary, eta {:.3f}, roughness {}: {} bins, p {:.3f} (limit {}); f |cos| adds up to {:.4f} +- "
                "{:.4f}\n",
                eta, roughness, used, p, kSignificance, total, std::sqrt(variance));
            EXPECT_GT(p, kSignificance);
            EXPECT_NEAR(total, 1.0, 3.5 * std::sqrt(variance));
            EXPECT_LT(std::sqrt(variance), 0.01) << "too few samples to tell";
        }
}

}  // namespace
}  // namespace tyndall::reference
