// Directions of phase functions, and distances along rays, follow their densities.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "chi_square.h"
#include "physics/physics.h"
#include "reference/phase.h"
#include "reference/sampler.h"

namespace tyndall::reference {
namespace {

using glm::vec3;
using glm::vec4;

/// Integrals of 2 pi f(cos x) sin x over even parts of 0..pi, by Simpson's rule.
std::vector<double> ring_integrals(size_t bins, FunctionRef<double(double)> f) {
    constexpr int kSteps = 100;
    std::vector<double> sums(bins);
    const double width = std::numbers::pi / static_cast<double>(bins);
    for (size_t bin = 0; bin < bins; ++bin)
        for (int i = 0; i <= kSteps; ++i) {
            const double x = width * (static_cast<double>(bin) + static_cast<double>(i) / kSteps);
            const double weight = i == 0 || i == kSteps ? 1.0 : i % 2 == 1 ? 4.0 : 2.0;
            sums[bin] += weight * width / kSteps / 3.0 * 2.0 * std::numbers::pi * std::sin(x) * f(std::cos(x));
        }
    return sums;
}

void expect_follows(const std::string& what, const PhaseFunction& function, uint32_t seed) {
    constexpr size_t kBins = 90;
    constexpr int kSamples = 400000;
    const Phase phase(function);
    std::vector<double> expected =
        ring_integrals(kBins, [&](double u) { return static_cast<double>(phase.pdf(static_cast<float>(u))); });
    for (double& value : expected) value *= kSamples;
    std::vector<double> observed(kBins);
    Dice dice(seed);
    for (int i = 0; i < kSamples; ++i) {
        const float x = dice();
        const double angle = std::acos(std::clamp(static_cast<double>(phase.sample({x, dice()})), -1.0, 1.0));
        ++observed[std::min(static_cast<size_t>(angle / std::numbers::pi * kBins), kBins - 1)];
    }
    expect_distribution(what, expected, observed);
}

TEST(Samplers, PhaseFunctions) {
    struct Case {
        const char* name;
        PhaseKind kind;
        vec4 parameters;
    };
    const Case cases[] = {{"isotropic", PhaseKind::isotropic, vec4(0.0f)},
                          {"Rayleigh", PhaseKind::rayleigh, vec4(0.0f)},
                          {"Henyey-Greenstein 0", PhaseKind::henyey_greenstein, vec4(0.0f)},
                          {"Henyey-Greenstein 0.6", PhaseKind::henyey_greenstein, vec4(0.6f, 0, 0, 0)},
                          {"Henyey-Greenstein 0.95", PhaseKind::henyey_greenstein, vec4(0.95f, 0, 0, 0)},
                          {"Henyey-Greenstein -0.4", PhaseKind::henyey_greenstein, vec4(-0.4f, 0, 0, 0)},
                          {"Schlick 0.7", PhaseKind::schlick, vec4(0.7f, 0, 0, 0)},
                          {"Cornette-Shanks 0.1", PhaseKind::cornette_shanks, vec4(0.1f, 0, 0, 0)},
                          {"Cornette-Shanks 0.8", PhaseKind::cornette_shanks, vec4(0.8f, 0, 0, 0)},
                          {"two lobes", PhaseKind::two_lobe, vec4(0.8f, -0.3f, 0.35f, 0)},
                          {"Draine", PhaseKind::draine, vec4(0.5f, 4.0f, 0, 0)},
                          {"droplets of 8 um", PhaseKind::mie_droplets, physics::mie_droplet_fit(8.0f)},
                          {"droplets of 40 um", PhaseKind::mie_droplets, physics::mie_droplet_fit(40.0f)}};
    uint32_t seed = 100;
    for (const Case& c : cases) expect_follows(c.name, {c.kind, c.parameters, nullptr}, ++seed);
}

TEST(Samplers, TabulatedPhaseFunction) {
    auto table = std::make_shared<PhaseTable>();
    for (int i = 0; i <= 40; ++i) {  // a bow that differs between the channels, and a narrow lobe forward
        const float x = static_cast<float>(i) / 40.0f;
        const auto bow = [&](float at) { return 0.02f + 0.3f * std::exp(-300.0f * (x - at) * (x - at)); };
        table->values.emplace_back(vec3(bow(0.72f), bow(0.75f), bow(0.78f)) + std::exp(-30.0f * x));
    }
    for (int c = 0; c < 3; ++c) {
        const auto value = [&](double u) {
            const double at = std::acos(u) / std::numbers::pi * 40.0;
            const auto low = std::min(static_cast<size_t>(at), size_t{39});
            const double part = at - static_cast<double>(low);
            return (1.0 - part) * static_cast<double>(table->values[low][c]) +
                   part * static_cast<double>(table->values[low + 1][c]);
        };
        double sum = 0.0;
        for (const double part : ring_integrals(80, value)) sum += part;
        for (vec3& v : table->values) v[c] /= static_cast<float>(sum);
    }
    expect_follows("table", {PhaseKind::tabulated, vec4(0.0f), table}, 200);
}

TEST(Samplers, EquiAngular) {
    constexpr size_t kBins = 100;
    constexpr int kSamples = 400000;
    const vec3 origin(0.0f), direction(0.0f, 0.0f, -1.0f);
    uint32_t seed = 300;
    for (const vec3& light : {vec3(0.3f, 0.2f, -2.0f), vec3(1.0f, 0.0f, 3.0f), vec3(0.0f, 0.4f, -9.0f)}) {
        constexpr float kLow = 0.5f, kHigh = 6.0f;
        std::vector<double> expected(kBins), observed(kBins);
        const double side = glm::length(glm::dvec2(light)), foot = -static_cast<double>(light.z);
        const auto angle = [&](double t) { return std::atan((t - foot) / side); };
        for (size_t i = 0; i < kBins; ++i) {
            const double step = static_cast<double>(kHigh - kLow) / kBins;
            const double t = static_cast<double>(kLow) + step * static_cast<double>(i);
            expected[i] = kSamples * (angle(t + step) - angle(t)) / (angle(6.0) - angle(0.5));
        }
        Dice dice(++seed);
        double worst = 0.0;
        for (int i = 0; i < kSamples; ++i) {
            float pdf = 0.0f;
            const float t = physics::sample_equi_angular(dice(), kLow, kHigh, origin, direction, light, pdf);
            const double off = static_cast<double>(t) - foot;
            const double density = side / ((angle(6.0) - angle(0.5)) * (side * side + off * off));
            worst = std::max(worst, std::abs(static_cast<double>(pdf) / density - 1.0));
            ++observed[std::min(static_cast<size_t>((t - kLow) / (kHigh - kLow) * kBins), kBins - 1)];
        }
        expect_distribution(fmt::format("equi-angular, lamp at z {}", light.z), expected, observed);
        EXPECT_LT(worst, 1e-4);
    }
}

TEST(Samplers, ABatchIsStratified) {
    // Every pair of dimensions is a (0, 2)-sequence: of 256 points, one is in each box of 2^-k by 2^(k-8).
    for (uint32_t seed = 0; seed < 8; ++seed) {
        std::vector<Sampler> samplers;
        for (uint32_t i = 0; i < 256; ++i) samplers.emplace_back(glm::uvec2(seed, 7), seed, 5, i);
        for (int pair = 0; pair < 32; ++pair) {
            std::vector<glm::vec2> points;
            for (Sampler& sampler : samplers) points.push_back(sampler.next2());
            for (int k = 0; k <= 8; ++k) {
                const int columns = 1 << k, rows = 256 >> k;
                std::vector<int> boxes(256);
                for (const glm::vec2& p : points)
                    ++boxes[static_cast<size_t>(static_cast<int>(p.y * static_cast<float>(rows)) * columns +
                                                static_cast<int>(p.x * static_cast<float>(columns)))];
                EXPECT_EQ(std::ranges::count(boxes, 1), 256)
                    << "pair " << pair << ", boxes of " << columns << "x" << rows;
            }
        }
    }
}

}  // namespace
}  // namespace tyndall::reference
