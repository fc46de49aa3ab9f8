// Gradient noise: its moments, its continuity, and the coverage that its density promises.

#include "physics_test.h"

namespace tyndall::physics {
namespace {

vec3 place(Random& random) {
    return {random.between(-400, 400), random.between(-400, 400), random.between(-400, 400)};
}

TEST(Noise, HasTheMomentsThatItsNormalisationAssumes) {
    Random random(5);
    double sum = 0, squares = 0, product = 0, greatest = 0;
    constexpr int kCount = 400000;
    for (int i = 0; i < kCount; ++i) {
        const vec3 p = place(random);
        const double a = gradient_noise(p, hash_pcg(0)), b = gradient_noise(p, hash_pcg(1));
        sum += a;
        squares += a * a;
        product += a * b;
        greatest = std::max(greatest, std::abs(a));
    }
    measured("variance of gradient noise", squares / kCount);
    EXPECT_NEAR(sum / kCount, 0.0, 0.002);
    EXPECT_NEAR(squares / kCount / double(kGradientNoiseVariance), 1.0, 0.02);
    EXPECT_NEAR(product / squares, 0.0, 0.02) << "seeds are independent";
    EXPECT_LT(greatest, 1.04);
    EXPECT_GT(greatest, 0.8);
}

TEST(Noise, VanishesOnTheLatticeAndIsContinuousAcrossCells) {
    Random random(6);
    for (int i = 0; i < 2000; ++i) {
        const vec3 p = place(random);
        const vec3 cell = floor(p);
        EXPECT_EQ(gradient_noise(cell, 7u), 0.0f);
        vec3 face = p;
        face[i % 3] = cell[i % 3];
        vec3 before = face, after = face;
        before[i % 3] = std::nextafter(face[i % 3], -1e9f);
        after[i % 3] = std::nextafter(face[i % 3], 1e9f);
        // places 3e-5 apart at most, slopes below 3.9
        EXPECT_NEAR(gradient_noise(before, 7u), gradient_noise(after, 7u), 2.5e-4f) << i;
    }
    EXPECT_NEAR(gradient_noise(vec3(-1e-9f, 0.5f, 0.5f), 7u), gradient_noise(vec3(0.0f, 0.5f, 0.5f), 7u), 1e-6f);
    EXPECT_TRUE(std::isfinite(gradient_noise(vec3(-3e12f, 1e20f, 16777216.0f), 7u)));
}

TEST(Noise, DensityCoversTheShareOfSpaceThatItSays) {
    for (const float coverage : {0.0f, 0.1f, 0.5f, 0.9f, 1.0f}) {
        Random random(8);
        double covered = 0, sum = 0;
        constexpr int kCount = 40000;
        for (int i = 0; i < kCount; ++i) {
            const float density = noise_density(place(random), 4, coverage);
            ASSERT_GE(density, 0.0f);
            ASSERT_LE(density, 1.0f);
            covered += density > 0.0f;
            sum += double(density);
        }
        EXPECT_NEAR(covered / kCount, double(coverage), 0.03) << coverage;
        EXPECT_NEAR(sum / kCount, 0.5 * double(coverage), 0.02) << coverage;
    }
}

TEST(Noise, MoreOctavesAddFinerFeatures) {
    Random random(9);
    const auto roughness = [&](int octaves) {
        double sum = 0;
        for (int i = 0; i < 5000; ++i) {
            const vec3 p = place(random);
            sum += std::abs(double(fractal_noise(p + vec3(0.02f, 0, 0), octaves) - fractal_noise(p, octaves)));
        }
        return sum;
    };
    EXPECT_GT(roughness(5), 1.7 * roughness(1));
}

}  // namespace
}  // namespace tyndall::physics
