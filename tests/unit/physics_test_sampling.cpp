#include "physics_test.h"

namespace tyndall::physics {
namespace {

/// Fills `kBins` x `kBins` boxes of (z, azimuth), which have equal solid angles, and compares with density(z).
double direction_excess(const std::function<vec3(vec2)>& sample, const std::function<double(double)>& mass_in_z) {
    constexpr int kBins = 12, kSamples = 200000;
    Random random(31);
    std::vector<double> counts(kBins * kBins), expected(kBins * kBins);
    for (int i = 0; i < kSamples; ++i) {
        const vec3 d = sample(random.pair());
        EXPECT_NEAR(length(d), 1.0f, 1e-5f);
        const int x = clamp(int((d.z * 0.5f + 0.5f) * kBins), 0, kBins - 1);
        const int y = clamp(int((std::atan2(d.y, d.x) / kTwoPi + 0.5f) * kBins), 0, kBins - 1);
        ++counts[size_t(y * kBins + x)];
    }
    for (int i = 0; i < kBins * kBins; ++i) {
        const double z = -1 + 2.0 * (i % kBins) / kBins;
        expected[size_t(i)] = kSamples * integrate(mass_in_z, z, z + 2.0 / kBins, 100) / kBins;
    }
    return chi_square_excess(counts, expected);
}

TEST(Sampling, DirectionsHaveTheirDensities) {
    const double worst =
        std::max({direction_excess(sample_uniform_sphere, [](double) { return 0.5; }),
                  direction_excess(sample_uniform_hemisphere, [](double z) { return z > 0 ? 1.0 : 0.0; }),
                  direction_excess(sample_cosine_hemisphere, [](double z) { return z > 0 ? 2 * z : 0.0; }),
                  direction_excess(
                      [](vec2 xi) { return sample_uniform_cone(xi, 0.5f); },
                      [](double z) { return z > 0.5 ? 2 * 3.14159265358979 * double(uniform_cone_pdf(0.5f)) : 0.0; })});
    EXPECT_LT(worst, 4.0);
    measured("direction samplers, worst chi-square excess (sigma)", worst);
}

TEST(Sampling, DiscIsUniform) {
    constexpr int kRings = 10, kSectors = 12, kSamples = 100000;
    Random random(6);
    std::vector<double> counts(kRings * kSectors), expected(kRings * kSectors, double(kSamples) / (kRings * kSectors));
    for (int i = 0; i < kSamples; ++i) {
        const vec2 p = sample_concentric_disc(random.pair());
        const int ring = std::min(int(dot(p, p) * kRings), kRings - 1);
        const int sector = clamp(int((std::atan2(p.y, p.x) / kTwoPi + 0.5f) * kSectors), 0, kSectors - 1);
        ++counts[size_t(ring * kSectors + sector)];
    }
    EXPECT_LT(chi_square_excess(counts, expected), 4.0);
    EXPECT_EQ(sample_concentric_disc(vec2(0.5f)), vec2(0));
}

TEST(Sampling, FramesAreOrthonormal) {
    Random random(7);
    std::vector<vec3> normals{{0, 0, 1}, {0, 0, -1}, {1, 0, 0}, {1e-5f, 0, -1}};
    for (int i = 0; i < 200; ++i) normals.push_back(random.direction());
    for (const vec3& n : normals) {
        vec3 t, b;
        orthonormal_basis(n, t, b);
        EXPECT_NEAR(dot(t, n), 0, 1e-6f);
        EXPECT_NEAR(dot(b, n), 0, 1e-6f);
        EXPECT_NEAR(dot(t, b), 0, 1e-6f);
        EXPECT_NEAR(length(t) * length(b), 1, 1e-5f);
        EXPECT_GT(dot(cross(t, b), n), 0.99f);  // right-handed
        EXPECT_NEAR(dot(direction_about(n, 0.3f, random()), n), 0.3f, 1e-5f);
    }
}

TEST(Sequences, StayBelowOneAndSpread) {
    EXPECT_LT(unit_float(0xffffffffu), 1.0f);
    EXPECT_EQ(radical_inverse_2(1), 0.5f);
    EXPECT_EQ(radical_inverse_2(6), 0.375f);
    constexpr int kPoints = 4096, kGrid = 16;
    // a low-discrepancy set puts nearly the same number of points into every box; random points would miss by 16
    for (const bool r2 : {false, true}) {
        std::vector<int> boxes(kGrid * kGrid);
        for (unsigned i = 0; i < kPoints; ++i) {
            const vec2 p = r2 ? r2_sequence(i) : hammersley(i, kPoints);
            ++boxes[size_t(p.y * kGrid) * kGrid + size_t(p.x * kGrid)];
        }
        const auto [low, high] = std::minmax_element(boxes.begin(), boxes.end());
        EXPECT_LE(*high - *low, r2 ? 6 : 0) << r2;
    }
}

TEST(Sequences, HashAndDitherAreUniform) {
    std::vector<double> counts(64), dither(64);
    unsigned state = 1;
    for (unsigned i = 0; i < 64000; ++i) {
        ++counts[hash_pcg(i) >> 26];
        ++dither[size_t(interleaved_gradient_noise(vec2(float(i % 256), float(i / 256))) * 64)];
        ASSERT_LT(random_float(state), 1.0f);
    }
    EXPECT_LT(chi_square_excess(counts, std::vector<double>(64, 1000.0)), 4.0);
    EXPECT_LT(chi_square_excess(dither, std::vector<double>(64, 1000.0)), 4.0);
}

}  // namespace
}  // namespace tyndall::physics
