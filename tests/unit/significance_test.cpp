#include "image/significance.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "compare_pictures.h"
#include "core/error.h"

namespace tyndall {
namespace {

/// The mean of `samples` random samples in each pixel of a scene: normal, with a standard deviation of `noise` times
/// the pixel's radiance for one sample. The channels share most of their samples, as a path tracer's do.
NoisyPicture sampled(const Image& truth, double noise, int samples, unsigned seed, double bias = 0) {
    NoisyPicture picture{truth, truth};
    std::mt19937 random(seed);
    std::normal_distribution<double> normal;
    for (size_t i = 0; i < truth.value_count(); i += 3) {
        const double shared = normal(random);
        for (size_t c = i; c < i + 3; ++c) {
            const double value = static_cast<double>(truth.floats()[c]);
            const double deviation = noise * value / std::sqrt(samples);
            const double draw = 0.9 * shared + std::sqrt(1 - 0.81) * normal(random);
            picture.radiance.floats()[c] = static_cast<float>(value * (1 + bias) + deviation * draw);
            picture.variance.floats()[c] = static_cast<float>(deviation * deviation);
        }
    }
    return picture;
}

TEST(ZTest, FalseAlarmsAreAsRareAsStated) {
    const Image truth = waves(64, 48);
    constexpr int kRuns = 400;
    int at_10 = 0, at_1 = 0, worst = 0, spread = 0, mean = 0;
    for (unsigned run = 0; run < kRuns; ++run) {
        const ZTest z = z_test(sampled(truth, 0.5, 16, 2 * run + 1), sampled(truth, 0.5, 64, 2 * run + 2));
        at_10 += z.p < 0.1, at_1 += z.p < 0.01;
        worst += z.worst_p < 0.1, spread += z.spread_p < 0.1, mean += z.mean_p < 0.1;
    }
    // Not more than stated: 40 and 4 expected at most, with room for three standard deviations of the count.
    EXPECT_LE(at_10, 40 + 18);
    EXPECT_LE(at_1, 4 + 6);
    for (const int alarms : {worst, spread, mean}) EXPECT_LE(alarms, 40 + 18);
    // And not much less: a test that never sounds would pass the lines above.
    EXPECT_GE(at_10, 8);
    for (const int alarms : {worst, spread, mean}) EXPECT_GE(alarms, 8);
}

TEST(ZTest, SpreadOfNoiseIsOne) {
    const Image truth = waves(256, 192);
    const ZTest z = z_test(sampled(truth, 0.5, 16, 1), sampled(truth, 0.5, 16, 2), 0.05);
    EXPECT_EQ(z.tests, 3u * 32 * 24);
    EXPECT_NEAR(z.mean_square, 1, 0.15);
    EXPECT_NEAR(z.critical, 1.959964, 1e-5);
    EXPECT_NEAR(z.share_above, 0.05, 0.015);
    EXPECT_GT(z.p, 0.01);
}

TEST(ZTest, FindsHalfAPercentWhereTheDataAllowIt) {
    // 192x128 pixels of 10 % noise: the whole mean is known to 0.09 %, so half a percent is over 5 deviations.
    const Image truth = waves(192, 128);
    const ZTest z = z_test(sampled(truth, 0.1, 1, 11), sampled(truth, 0.1, 1, 12, 0.005));
    EXPECT_LT(z.mean_p, 1e-3);
    EXPECT_LT(z.p, 0.01);
    EXPECT_GT(z.mean_z, 4);
    // And no more than is there: at 300 % noise nobody could tell.
    EXPECT_GT(z_test(sampled(truth, 3, 1, 11), sampled(truth, 3, 1, 12, 0.005)).p, 0.01);
}

TEST(ZTest, FindsOneWrongBlockAndItsPlace) {
    const Image truth = waves(128, 96);
    NoisyPicture test = sampled(truth, 0.2, 4, 5);
    for (int y = 40; y < 48; ++y)
        for (int x = 72; x < 80; ++x) test.radiance.at(x, y, 2) -= 0.15f;
    const ZTest z = z_test(sampled(truth, 0.2, 4, 6), test);
    EXPECT_LT(z.worst_p, 1e-4);
    EXPECT_LT(z.worst, 0);
    EXPECT_EQ(z.worst_x, 72);
    EXPECT_EQ(z.worst_y, 40);
    EXPECT_EQ(z.worst_channel, 2);
    EXPECT_EQ(z.map.at(75, 45, 0), static_cast<float>(-z.worst));
}

TEST(ZTest, VariancesThatAreTooSmallShow) {
    const Image truth = waves(256, 192);
    NoisyPicture test = sampled(truth, 0.2, 4, 5);
    for (float& v : test.variance.floats()) v /= 2;
    const ZTest z = z_test(sampled(truth, 0.2, 4, 6), test);
    EXPECT_LT(z.spread_p, 1e-6);
    EXPECT_GT(z.mean_square, 1.15);
}

TEST(ZTest, ExactPixelsMustAgree) {
    const Image truth = waves(32, 24);
    const NoisyPicture exact{truth, filled(32, 24, 0, 0, 0)};
    const ZTest same = z_test(exact, exact);
    EXPECT_EQ(same.tests, 0u);
    EXPECT_EQ(same.p, 1);
    NoisyPicture other = exact;
    other.radiance.at(9, 1, 0) += 0.5f;
    const ZTest differs = z_test(exact, other);
    EXPECT_EQ(differs.exact_differences, 1u);
    EXPECT_EQ(differs.p, 0);
    EXPECT_EQ(differs.worst_x, 8);
}

TEST(ZTest, MaskLeavesOut) {
    const Image truth = waves(64, 48);
    NoisyPicture test = sampled(truth, 0.2, 4, 5);
    Mask mask(64 * 48, 1);
    for (size_t i = 0; i < mask.size(); ++i)
        if (i % 64 >= 40) mask[i] = 0, test.radiance.floats()[3 * i] = std::numeric_limits<float>::quiet_NaN();
    const NoisyPicture reference = sampled(truth, 0.2, 4, 6);
    EXPECT_GT(z_test(reference, test, 0.01, mask).p, 0.01);
    EXPECT_THROW((void)z_test(reference, test), Error);
}

TEST(ZTest, RefusesWhatIsNoVariance) {
    const Image truth = waves(16, 16);
    NoisyPicture test = sampled(truth, 0.2, 4, 5);
    const NoisyPicture reference = test;
    test.variance.at(3, 2, 1) = std::numeric_limits<float>::infinity();
    try {
        (void)z_test(reference, test);
        ADD_FAILURE() << "an infinite variance was taken";
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find("x 3, y 2"), std::string::npos) << error.what();
    }
    test.variance.at(3, 2, 1) = -1;
    EXPECT_THROW((void)z_test(reference, test), Error);
    EXPECT_THROW((void)z_test(reference, reference, 0), Error);
    EXPECT_THROW((void)z_test({truth, Image()}, reference), Error);
}

}  // namespace
}  // namespace tyndall
