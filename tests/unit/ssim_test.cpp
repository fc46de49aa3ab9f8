#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "compare_pictures.h"
#include "core/error.h"
#include "image/compare.h"

namespace tyndall {
namespace {

TEST(Ssim, IdenticalIsOne) {
    const SsimDifference d = compare_ssim(waves(48, 32), waves(48, 32));
    EXPECT_NEAR(d.mean, 1, 1e-12);
    EXPECT_NEAR(d.worst, 1, 1e-12);
}

TEST(Ssim, FlatPicturesFollowTheEquation) {
    // No structure: only the means' term is left, (2ab + C1) / (a^2 + b^2 + C1).
    const SsimDifference d = compare_ssim(filled(32, 32, 0.2f, 0.2f, 0.2f), filled(32, 32, 0.6f, 0.6f, 0.6f));
    EXPECT_NEAR(d.mean, (2 * 0.2 * 0.6 + 1e-4) / (0.2 * 0.2 + 0.6 * 0.6 + 1e-4), 1e-6);
}

TEST(Ssim, NegatedStructureIsNegative) {
    Image negative = waves(48, 32);
    for (float& v : negative.floats()) v = 1 - v;
    EXPECT_LT(compare_ssim(waves(48, 32), negative).worst, 0);
}

/// The same equation summed window by window, without separable filters or running means.
double by_hand(const Image& a, const Image& b, int x, int y) {
    double weight = 0, ma = 0, mb = 0, aa = 0, bb = 0, ab = 0;
    const auto luma = [](const Image& i, int u, int v) {
        return 0.2126 * static_cast<double>(i.at(u, v, 0)) + 0.7152 * static_cast<double>(i.at(u, v, 1)) +
               0.0722 * static_cast<double>(i.at(u, v, 2));
    };
    for (int v = y - 5; v <= y + 5; ++v)
        for (int u = x - 5; u <= x + 5; ++u) {
            const double w = std::exp(-((u - x) * (u - x) + (v - y) * (v - y)) / 4.5);
            const double p = luma(a, u, v), q = luma(b, u, v);
            weight += w, ma += w * p, mb += w * q, aa += w * p * p, bb += w * q * q, ab += w * p * q;
        }
    ma /= weight, mb /= weight;
    const double va = aa / weight - ma * ma, vb = bb / weight - mb * mb, cov = ab / weight - ma * mb;
    return (2 * ma * mb + 1e-4) * (2 * cov + 9e-4) / ((ma * ma + mb * mb + 1e-4) * (va + vb + 9e-4));
}

TEST(Ssim, MapFollowsTheDefinition) {
    const Image a = waves(40, 30);
    Image b = a;
    for (int y = 0; y < 30; ++y)
        for (int x = 0; x < 40; ++x)
            for (int c = 0; c < 3; ++c) b.at(x, y, c) += 0.1f * static_cast<float>(hashed(x, y, c) - 0.5);
    const SsimDifference d = compare_ssim(a, b);
    for (const auto& [x, y] : {std::pair{5, 5}, {20, 14}, {34, 24}})
        EXPECT_NEAR(static_cast<double>(d.map.at(x, y, 0)), by_hand(a, b, x, y), 1e-6) << x << ", " << y;
    EXPECT_EQ(d.map.at(0, 0, 0), d.map.at(5, 5, 0)) << "the border repeats";
    double sum = 0;
    for (int y = 5; y < 25; ++y)
        for (int x = 5; x < 35; ++x) sum += by_hand(a, b, x, y);
    EXPECT_NEAR(d.mean, sum / (20 * 30), 1e-6);
}

TEST(Ssim, SmallAndUnfitPictures) {
    EXPECT_NEAR(compare_ssim(waves(3, 2), waves(3, 2)).mean, 1, 1e-12);
    EXPECT_THROW((void)compare_ssim(waves(8, 8), waves(8, 9)), Error);
    Image bad = waves(16, 16);
    bad.at(3, 3, 0) = std::numeric_limits<float>::quiet_NaN();
    EXPECT_THROW((void)compare_ssim(waves(16, 16), bad), Error);
}

}  // namespace
}  // namespace tyndall
