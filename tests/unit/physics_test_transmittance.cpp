#include "physics_test.h"

namespace tyndall::physics {
namespace {

TEST(Segment, AgreesWithDoublePrecision) {
    double worst = 0, worst_vector = 0;
    for (double depth = 1e-9; depth <= 100; depth *= 1.01) {
        const float x = float(depth);
        const double exact = -std::expm1(-double(x)) / double(x);
        worst = std::max(worst, std::abs(double(mean_transmittance(x)) / exact - 1));
        worst_vector = std::max(worst_vector, std::abs(double(mean_transmittance(vec3(x)).y) / exact - 1));
        // as a segment: source 3 per metre, 0.7 m
        const double sigma = double(x / 0.7f);
        const double gathered = 3.0 * -std::expm1(-sigma * double(0.7f)) / sigma;
        EXPECT_NEAR(double(segment_integral(vec3(3), vec3(float(sigma)), 0.7f).x) / gathered, 1, 1e-6) << depth;
    }
    EXPECT_LT(worst, 5e-7);
    EXPECT_LT(worst_vector, 5e-7);
    measured("segment integral, worst relative error for optical depths 1e-9..100", std::max(worst, worst_vector));
    EXPECT_EQ(segment_integral(vec3(3), vec3(0), 0.5f), vec3(1.5f));
    EXPECT_NEAR(mean_transmittance(1e6f), 1e-6f, 1e-12f);
}

TEST(Segment, StepsAddUpToOneSegment) {
    const vec3 source(2, 1, 0.5f), sigma(0.0f, 0.7f, 30.0f);
    vec3 radiance(0), transmittance(1);
    for (int i = 0; i < 50; ++i) accumulate_segment(source, sigma, 0.1f, radiance, transmittance);
    const vec3 once = segment_integral(source, sigma, 5.0f);
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(radiance[k], once[k], 2e-6f * once[k]);
    EXPECT_NEAR(transmittance.y, std::exp(-3.5f), 1e-6f);
}

TEST(Segment, DistancesHaveTheDensity) {
    for (const float sigma : {0.0f, 1e-7f, 0.02f, 0.5f, 20.0f}) {
        constexpr int kBins = 40, kSamples = 100000;
        const float ds = 3.0f;
        Random random(5);
        std::vector<double> counts(kBins), expected(kBins);
        for (int i = 0; i < kSamples; ++i) {
            float pdf;
            const float t = sample_exponential_distance(random(), sigma, ds, pdf);
            ASSERT_TRUE(t >= 0 && t <= ds);
            const double exact = sigma * ds > 1e-6f
                                     ? double(sigma) * std::exp(-double(sigma * t)) / -std::expm1(-double(sigma * ds))
                                     : 1.0 / 3;
            ASSERT_NEAR(double(pdf), exact, 1e-5 * exact + 1e-12);
            ++counts[size_t(std::min(int(t / ds * kBins), kBins - 1))];
        }
        const auto density = [&](double t) { return std::exp(-double(sigma) * t); };
        const double total = integrate(density, 0, 3, 1000);
        for (int i = 0; i < kBins; ++i) {
            expected[size_t(i)] = kSamples * integrate(density, 3.0 * i / kBins, 3.0 * (i + 1) / kBins, 50) / total;
        }
        EXPECT_LT(chi_square_excess(counts, expected), 4.0) << sigma;
    }
}

TEST(Transmittance, ColorAtDistance) {
    const vec3 color(0.9f, 0.5f, 0.0f);
    const vec3 back = beer_lambert(sigma_t_from_color(color, 4.0f), 4.0f);
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(back[k], color[k], 2e-6f);
    EXPECT_TRUE(std::isfinite(sigma_t_from_color(vec3(0), 0.0f).x));
}

TEST(Transmittance, HeightFogAgreesWithQuadrature) {
    Random random(3);
    double worst = 0;
    for (int i = 0; i < 2000; ++i) {
        const float base = random.between(-5, 5), scale = random.between(0.5f, 50);
        const float ya = random.between(-20, 60);
        const float yb = i % 5 == 0 ? ya : i % 5 == 1 ? ya + random.between(-1e-4f, 1e-4f) : random.between(-20, 60);
        const float ds = std::abs(yb - ya) + random.between(0.1f, 40);
        const auto density = [&](double s) {
            return 0.3 * std::exp(-(double(ya) + (double(yb) - double(ya)) * s - double(base)) / double(scale));
        };
        const double exact = double(ds) * integrate(density, 0, 1, 200);
        if (exact < 1e-30) continue;  // below what 32 bits hold
        const double error = double(height_fog_optical_depth(0.3f, base, scale, ya, yb, ds)) / exact - 1;
        worst = std::max(worst, std::abs(error));
    }
    EXPECT_LT(worst, 1e-5);
    measured("height fog, worst relative error of the optical depth", worst);
}

TEST(Airlight, SunsClosedFormAgreesWithQuadrature) {
    double worst = 0;
    for (const double beta : {0.002, 0.03, 0.3, 1.5}) {
        for (const double light : {0.5, 4.0, 20.0}) {
            for (const double gamma : {0.01, 0.3, 1.2, 1.5707, 2.5, 3.1}) {
                for (const double surface : {0.3, 4.0, 25.0, 500.0}) {
                    if (beta * light > 12) continue;
                    // substitute t = closest + D tan x, which flattens 1/d^2
                    const double closest = light * std::cos(gamma), passing = light * std::sin(gamma);
                    const auto integrand = [&](double x) {
                        const double d = passing / std::cos(x), t = closest + passing * std::tan(x);
                        return std::exp(-beta * (t + d)) / passing;
                    };
                    const double from = std::atan(-closest / passing), to = std::atan((surface - closest) / passing);
                    const double exact = 100 * beta / (4 * 3.14159265358979) * integrate(integrand, from, to, 4000);
                    const double value =
                        double(airlight_point(100, float(beta), float(light), float(std::cos(gamma)), float(surface)));
                    const double error = std::abs(value / exact - 1);
                    // near the light's own direction the cosine alone does not hold the angle
                    EXPECT_LT(error, gamma < 0.02 || gamma > 3.05 ? 2e-2 : 1e-4)
                        << beta << ' ' << light << ' ' << gamma << ' ' << surface;
                    if (gamma >= 0.02 && gamma <= 3.05) worst = std::max(worst, error);
                }
            }
        }
    }
    measured("airlight (Sun 2005), worst relative error", worst);
}

TEST(Airlight, EquiAngularEstimatesWithoutBias) {
    Random random(11);
    for (int round = 0; round < 20; ++round) {
        const vec3 origin(0), direction = random.direction(), light = 4.0f * random.direction();
        const float t0 = random.between(0, 1), t1 = t0 + random.between(0.5f, 10);
        const double closest = double(dot(light, direction));
        const double passing2 = double(dot(light, light)) - closest * closest;
        const auto inverse_square = [&](double t) { return 1 / (passing2 + (t - closest) * (t - closest)); };
        const double exact = integrate(inverse_square, double(t0), double(t1), 2000);
        double pdf_mass = 0;
        for (int i = 0; i < 200; ++i) {
            float pdf;
            const float t = sample_equi_angular((float(i) + 0.5f) / 200, t0, t1, origin, direction, light, pdf);
            ASSERT_TRUE(t >= t0 && t <= t1);
            // the density is the integrand over its integral: each sample alone is the answer
            EXPECT_NEAR(inverse_square(double(t)) / double(pdf) / exact, 1, 2e-3);
            pdf_mass += 1 / double(pdf);
        }
        EXPECT_NEAR(pdf_mass / 200, double(t1 - t0), 2e-2 * double(t1 - t0));
    }
    float pdf;
    const float t = sample_equi_angular(0.5f, 0, 8, vec3(0), vec3(1, 0, 0), vec3(4, 0, 0), pdf);
    EXPECT_TRUE(std::isfinite(t) && std::isfinite(pdf) && pdf > 0);
}

TEST(Gaussian, ErrorFunctionIsTheStandardOne) {
    double worst = 0;
    for (double x = -6; x <= 6; x += 0.001)
        worst = std::max(worst, std::abs(double(error_function(float(x))) - std::erf(double(float(x)))));
    EXPECT_LT(worst, 5e-7);
    measured("error function, worst absolute error", worst);
}

TEST(Gaussian, LineIntegralAgreesWithQuadrature) {
    Random random(9);
    double worst = 0;
    for (int i = 0; i < 300; ++i) {
        const vec3 origin = 2.0f * random.direction(), direction = random.direction() * (0.2f + random());
        const vec3 center = 0.5f * random.direction();
        const float radius = 0.05f + 0.3f * random(), t0 = 2.0f * random(), t1 = t0 + 3.0f * random();
        double sum = 0;
        constexpr int kSteps = 4000;
        for (int k = 0; k < kSteps; ++k) {
            const double t = double(t0) + (k + 0.5) / kSteps * double(t1 - t0);
            const dvec3 p = dvec3(origin) + t * dvec3(direction) - dvec3(center);
            sum += std::exp(-dot(p, p) / (2.0 * double(radius) * double(radius))) * double(t1 - t0) / kSteps;
        }
        const double found = double(gaussian_line_integral(origin, direction, center, radius, t0, t1));
        worst = std::max(worst, std::abs(found - sum) / double(radius) * double(length(direction)));
    }
    EXPECT_LT(worst, 3e-6);
    measured("line integral of a Gaussian, worst error in its radii", worst);
}

}  // namespace
}  // namespace tyndall::physics
