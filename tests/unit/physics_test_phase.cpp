#include "physics_test.h"

namespace tyndall::physics {
namespace {

struct PhaseCase {
    const char* name;
    int kind;
    vec4 parameters;
};

std::vector<PhaseCase> phase_cases() {
    return {{"isotropic", PHASE_ISOTROPIC, vec4(0)},
            {"Rayleigh", PHASE_RAYLEIGH, vec4(0)},
            {"HG 0", PHASE_HENYEY_GREENSTEIN, vec4(0)},
            {"HG 0.6", PHASE_HENYEY_GREENSTEIN, vec4(0.6f, 0, 0, 0)},
            {"HG -0.9", PHASE_HENYEY_GREENSTEIN, vec4(-0.9f, 0, 0, 0)},
            {"Schlick 0.05", PHASE_SCHLICK, vec4(0.05f, 0, 0, 0)},
            {"Schlick of g 0.6", PHASE_SCHLICK, vec4(schlick_k_from_g(0.6f), 0, 0, 0)},
            {"Schlick of g -0.8", PHASE_SCHLICK, vec4(schlick_k_from_g(-0.8f), 0, 0, 0)},
            {"Cornette-Shanks 0.3", PHASE_CORNETTE_SHANKS, vec4(0.3f, 0, 0, 0)},
            {"Cornette-Shanks 0", PHASE_CORNETTE_SHANKS, vec4(0)},
            {"two lobes", PHASE_TWO_LOBE, vec4(0.8f, -0.4f, 0.3f, 0)},
            {"Draine 0.1, 4", PHASE_DRAINE, vec4(0.1f, 4, 0, 0)},
            {"Draine -0.25, 2", PHASE_DRAINE, vec4(-0.25f, 2, 0, 0)},
            {"Draine 0.7, 30", PHASE_DRAINE, vec4(0.7f, 30, 0, 0)},
            {"droplets 5 um", PHASE_MIE_DROPLETS, mie_droplet_fit(5)},
            {"droplets 20 um", PHASE_MIE_DROPLETS, mie_droplet_fit(20)}};
}

/// Integral of f(u) times the phase function over the part of the sphere with u in low..high; u = sin(x) crowds the
/// cells toward both ends, for the narrow lobes.
double sphere_integral(const PhaseCase& c, const std::function<double(double)>& f, double low = -1, double high = 1) {
    const auto inner = [&](double x) {
        const double p = double(phase_evaluate(c.kind, c.parameters, float(std::sin(x))));
        return f(std::sin(x)) * p * std::cos(x);
    };
    return 2 * 3.14159265358979 * integrate(inner, std::asin(low), std::asin(high), 10000);
}

TEST(Phase, IntegratesToOne) {
    double worst = 0;
    for (const PhaseCase& c : phase_cases()) {
        const double total = sphere_integral(c, [](double) { return 1.0; });
        EXPECT_NEAR(total, 1.0, 1e-5) << c.name;
        worst = std::max(worst, std::abs(total - 1));
    }
    measured("phase functions, worst |integral - 1|", worst);
}

TEST(Phase, MeanCosineIsAsStated) {
    double worst = 0;
    for (const PhaseCase& c : phase_cases()) {
        const double mean = sphere_integral(c, [](double u) { return u; });
        EXPECT_NEAR(double(phase_mean_cosine(c.kind, c.parameters)), mean, 1e-5) << c.name;
        worst = std::max(worst, std::abs(double(phase_mean_cosine(c.kind, c.parameters)) - mean));
    }
    measured("phase functions, worst error of the mean cosine", worst);
}

TEST(Phase, MeanCosineOfTheLiterature) {
    EXPECT_NEAR(schlick_mean_cosine(schlick_k_from_g(0.3f)), 0.313f, 6e-4f);
    EXPECT_NEAR(schlick_mean_cosine(schlick_k_from_g(0.6f)), 0.645f, 6e-4f);
    EXPECT_NEAR(schlick_mean_cosine(schlick_k_from_g(0.9f)), 0.971f, 6e-4f);
    EXPECT_NEAR(cornette_shanks_mean_cosine(0.3f), 0.352f, 6e-4f);
}

TEST(Phase, PointsForward) {
    for (const PhaseCase& c : phase_cases()) {
        if (phase_mean_cosine(c.kind, c.parameters) <= 0.0f) continue;
        EXPECT_GT(phase_evaluate(c.kind, c.parameters, 1), phase_evaluate(c.kind, c.parameters, -1)) << c.name;
    }
}

TEST(Phase, LimitsMeet) {
    for (float u = -1; u <= 1; u += 0.125f) {
        EXPECT_NEAR(phase_cornette_shanks(u, 0), phase_rayleigh(u), 1e-7f);
        EXPECT_NEAR(phase_draine(u, 0.5f, 0), phase_henyey_greenstein(u, 0.5f), 1e-6f);
        EXPECT_NEAR(phase_henyey_greenstein(u, 0), phase_isotropic(), 1e-7f);
    }
    EXPECT_EQ(phase_evaluate(PHASE_COUNT, vec4(0.5f), 0.3f), 0.0f);
}

TEST(Phase, SamplesHaveTheDensity) {
    constexpr int kBins = 64, kSamples = 400000;
    double worst = -100;
    for (const PhaseCase& c : phase_cases()) {
        Random random(17);
        std::vector<double> counts(kBins), expected(kBins);
        double sum = 0;
        for (int i = 0; i < kSamples; ++i) {
            const float u = phase_sample(c.kind, c.parameters, random.pair());
            ASSERT_TRUE(u >= -1.0f && u <= 1.0f) << c.name << ' ' << u;
            ++counts[size_t(std::min(int((u + 1) * 0.5f * kBins), kBins - 1))];
            sum += double(u);
        }
        for (int i = 0; i < kBins; ++i) {
            const double low = -1 + 2.0 * i / kBins;
            expected[size_t(i)] = kSamples * sphere_integral(
                                                 c, [](double) { return 1.0; }, low, low + 2.0 / kBins);
        }
        const double excess = chi_square_excess(counts, expected);
        EXPECT_LT(excess, 4.0) << c.name;
        EXPECT_NEAR(sum / kSamples, double(phase_mean_cosine(c.kind, c.parameters)), 5e-3) << c.name;
        worst = std::max(worst, excess);
    }
    measured("phase samplers, worst chi-square excess (sigma)", worst);
}

}  // namespace
}  // namespace tyndall::physics
