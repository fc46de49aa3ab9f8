// Profiles of diffusion: what Gaussians make of them.

#include <array>
#include <cmath>
#include <string>

#include "physics/hankel.h"
#include "physics/layered_diffusion.h"
#include "physics/non_negative.h"
#include "physics/profile_fit.h"
#include "physics/skin_profiles.h"
#include "physics_test.h"

namespace tyndall::physics {
namespace {

RadialFunction of(const DiffusionProfile& profile) {
    return [profile](double r) { return dvec3(profile.at(float(r))); };
}

RadialFunction standard_skin() {
    const Diffusion m = make_diffusion(vec3(740, 880, 1010), vec3(32, 170, 480), 0.0f, 1.3f);
    return [m](double r) { return dvec3(standard_dipole(m, float(r))); };
}

TEST(NonNegative, FindsWeightsAndKeepsThemPositive) {
    // three functions of which the third would have to be taken away
    NonNegativeEquations equations(3);
    for (int i = 0; i < 40; ++i) {
        const double x = i * 0.1;
        const std::array<double, 3> basis{1.0, x, x * x};
        equations.add(basis, 2.0 + 3.0 * x - 0.5 * x * x, 1.0);
    }
    const std::vector<double> w = equations.solve();
    EXPECT_EQ(w[2], 0.0);
    // the line that is nearest: by hand, from the sums of x and x^2
    double n = 0, sx = 0, sxx = 0, sy = 0, sxy = 0;
    for (int i = 0; i < 40; ++i) {
        const double x = i * 0.1, y = 2.0 + 3.0 * x - 0.5 * x * x;
        n += 1, sx += x, sxx += x * x, sy += y, sxy += x * y;
    }
    const double slope = (n * sxy - sx * sy) / (n * sxx - sx * sx);
    EXPECT_NEAR(w[1], slope, 1e-6);
    EXPECT_NEAR(w[0], (sy - slope * sx) / n, 1e-6);
    const std::array<double, 3> more{w[0], w[1] * 1.01, 0.0};
    EXPECT_GT(equations.error(more), equations.error(w));
}

TEST(RadialProfile, HasTheEdgesOfGaussians) {
    const DiffusionProfile six = six_gaussian_skin();
    const RadialProfile table(of(six));
    double worst = 0.0;
    for (double x = 1e-5; x < 2e-2; x *= 1.5)
        for (int c = 0; c < 3; ++c) worst = std::max(worst, std::abs(table.edge(x)[c] - double(six.edge(float(x))[c])));
    measured("edges by rings against closed form, worst", worst);
    EXPECT_LT(worst, 5e-4);
    EXPECT_NEAR(table.total().x, 1.0, 1e-3);
    EXPECT_NEAR(table.distance(0.5, 2), 0.128e-3, 0.02e-3);
}

TEST(RadialProfile, HasTheEdgeThatQuadratureOverThePlaneFinds) {
    const RadialFunction exact = standard_skin();
    const RadialProfile table(exact);
    const auto over_line = [&](double x) {  // the other half of the line is alike
        return 2.0 * integrate([&](double u) { return std::exp(u) * exact(std::hypot(x, std::exp(u))).y; },
                               std::log(1e-8), std::log(0.1), 60);
    };
    double worst = 0.0;
    for (const double x : {1e-4, 5e-4, 2e-3, 6e-3}) {
        const double beyond = integrate(over_line, x, x + 0.03, 200) / table.total().y;
        worst = std::max(worst, std::abs(1.0 - beyond - table.edge(x).y));
    }
    measured("edge of the standard dipole by rings against quadrature, worst", worst);
    EXPECT_LT(worst, 1e-3);
}

void expect_fit(const char* name, const RadialFunction& exact) {
    const RadialProfile wanted(exact);
    const ProfileFit fit = fit_profile(wanted);
    std::printf("%-20s r R(r) off by %.3f %.3f %.3f, edge by %.4f %.4f %.4f\n", name, fit.error.x, fit.error.y,
                fit.error.z, fit.edge_error.x, fit.edge_error.y, fit.edge_error.z);
    for (int c = 0; c < 3; ++c) {
        EXPECT_LT(fit.edge_error[c], 0.005) << name;
        double sum = 0.0;
        for (const DiffusionLobe& lobe : fit.profile.lobes) {
            EXPECT_GE(lobe.weight[c], 0.0f);
            sum += double(lobe.weight[c]);
        }
        EXPECT_NEAR(sum, 1.0, 1e-5);
        const double asked = edge_width([&](double x) { return wanted.edge(x)[c]; });
        const double got = edge_width([&](double x) { return double(fit.profile.edge(float(x))[c]); });
        EXPECT_NEAR(got, asked, 0.03 * asked) << name;
    }
}

TEST(ProfileFit, EdgesAreThoseOfTheProfile) {
    expect_fit("six Gaussians", of(six_gaussian_skin()));
    expect_fit("standard, skin1", standard_skin());
    expect_fit("skin1", solid_exitance({jensen_skin1()}));
    expect_fit("skin2", solid_exitance({jensen_skin2()}));
    expect_fit("three layers", solid_exitance(three_layer_skin()));
    for (const bool second : {false, true}) {
        const SolidLayer skin = second ? jensen_skin2() : jensen_skin1();
        const std::string name = second ? "skin2" : "skin1";
        const Diffusion m = make_diffusion(vec3(skin.sigma_s_reduced), vec3(skin.sigma_a), 0.0f, 1.3f);
        expect_fit(("better, " + name).c_str(), [&](double r) { return dvec3(better_dipole(m, float(r))); });
        expect_fit(("beams, " + name).c_str(), [&](double r) { return dvec3(photon_beam_diffusion(m, float(r), 64)); });
        expect_fit(("normalised, " + name).c_str(), [&](double r) {
            return dvec3(normalised_diffusion(vec3(0.46f, 0.23f, 0.13f), 1.0f / m.sigma_t_reduced, float(r)));
        });
    }
}

TEST(ProfileFit, FindsOneGaussianAndSurvivesNothing) {
    const DiffusionProfile one{{{2e-6f, vec3(1.0f)}}};
    const ProfileFit fit = fit_profile(RadialProfile(of(one)), 1);
    ASSERT_EQ(fit.profile.lobes.size(), 1u);
    EXPECT_NEAR(fit.profile.lobes[0].variance_m2, 2e-6f, 0.05e-6f);
    const ProfileFit none = fit_profile(RadialProfile([](double) { return dvec3(0.0); }));
    EXPECT_TRUE(none.profile.lobes.empty());
    const ProfileFit bad = fit_profile(RadialProfile([](double) { return dvec3(std::nan("")); }));
    EXPECT_TRUE(bad.profile.lobes.empty());
}

TEST(Hankel, GivesWhatIsKnownInClosedForm) {
    constexpr double kZ = 1e-3, kSigma = 300.0, kM = 800.0;
    double worst = 0.0, worst_singular = 0.0;
    for (double r = 1e-6; r < 1e-2; r *= 2.0) {
        const double d = std::hypot(r, kZ);
        const double flux = kZ * (1.0 + kSigma * d) * std::exp(-kSigma * d) / (2.0 * double(kPi) * d * d * d);
        const double found =
            inverse_hankel([&](double k) { return dvec3(std::exp(-kZ * std::hypot(kSigma, k))); }, r).x;
        worst = std::max(worst, std::abs(found / flux - 1.0));
        const double yukawa = kM * std::exp(-kM * r) / (2.0 * double(kPi) * r);
        const double singular = inverse_hankel([&](double k) { return dvec3(kM / std::hypot(kM, k)); }, r).x;
        worst_singular = std::max(worst_singular, std::abs(singular / yukawa - 1.0));
    }
    measured("inverse Hankel of a source in the depth, worst relative error", worst);
    measured("inverse Hankel of what goes as 1/r, worst relative error", worst_singular);
    EXPECT_LT(worst, 2e-3);
    EXPECT_LT(worst_singular, 1e-2);
}

}  // namespace
}  // namespace tyndall::physics
