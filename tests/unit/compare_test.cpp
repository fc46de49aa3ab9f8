#include "image/compare.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <limits>
#include <random>

#include "compare_pictures.h"
#include "core/error.h"
#include "image/image_io.h"

namespace tyndall {
namespace {

Image noisy(const Image& image, float amount) {
    Image out = image;
    std::mt19937 random(3);
    for (float& v : out.floats()) v += amount * (static_cast<float>(random() % 2001) / 1000.0f - 1.0f);
    return out;
}

TEST(CompareLinear, IdenticalIsZero) {
    const Image image = waves(64, 48);
    const LinearDifference d = compare_linear(image, image);
    EXPECT_EQ(d.relative_mse, 0);
    EXPECT_EQ(d.mean_ratio, 1);
    EXPECT_EQ(d.max_difference, 0);
    EXPECT_EQ(d.failing_fraction, 0);
    EXPECT_NEAR(d.psnr_db, 120, 1e-9);
}

TEST(CompareLinear, KnownValues) {
    // r = 1, t = 1.1 everywhere: 0.01 / (1 + 0.01).
    const LinearDifference d = compare_linear(filled(16, 16, 1, 1, 1), filled(16, 16, 1.1f, 1.1f, 1.1f), 0.05);
    EXPECT_NEAR(d.relative_mse, 0.01 / 1.01, 1e-6);
    EXPECT_NEAR(d.mean_ratio, 1.1, 1e-6);
    EXPECT_NEAR(d.max_difference, 0.1, 1e-6);
    EXPECT_EQ(d.failing_fraction, 1);

    Image one_block = waves(32, 32);
    for (int y = 8; y < 16; ++y)
        for (int x = 16; x < 24; ++x) one_block.at(x, y, 1) += 0.5f;
    const LinearDifference block = compare_linear(waves(32, 32), one_block);
    EXPECT_EQ(block.worst_block_x, 16);
    EXPECT_EQ(block.worst_block_y, 8);
    EXPECT_NEAR(block.failing_fraction, 1.0 / 16, 1e-9);
    EXPECT_NEAR(block.worst_block, block.relative_mse * 16, 1e-6);
    EXPECT_GT(block.channel_mean_ratio[1], 1.01);
    EXPECT_EQ(block.channel_mean_ratio[0], 1);
}

TEST(CompareLinear, LargerTestIsBoxFiltered) {
    const Image reference = waves(20, 10);
    EXPECT_EQ(compare_linear(reference, resize(reference, 80, 40)).relative_mse, 0);
    EXPECT_THROW((void)compare_linear(reference, waves(30, 15)), Error);
    EXPECT_THROW((void)compare_linear(reference, waves(40, 10)), Error);
    EXPECT_THROW((void)compare_linear(reference, waves(10, 5)), Error);
}

TEST(CompareLinear, NotFiniteNeverPasses) {
    Image bad = waves(16, 16);
    bad.at(3, 3, 0) = std::numeric_limits<float>::quiet_NaN();
    bad.at(4, 3, 0) = std::numeric_limits<float>::infinity();
    const LinearDifference d = compare_linear(waves(16, 16), bad);
    EXPECT_EQ(d.not_finite, 2u);
    EXPECT_EQ(d.not_finite_x, 3);
    EXPECT_EQ(d.not_finite_y, 3);
    EXPECT_TRUE(std::isinf(d.relative_mse));
    EXPECT_THROW((void)compare_linear(bad, waves(16, 16)), Error);
}

TEST(CompareLinear, MaskLeavesOut) {
    const Image reference = waves(32, 32);
    Image test = reference, shape(32, 32, 1, Image::Type::u8);
    for (int y = 0; y < 32; ++y)
        for (int x = 0; x < 32; ++x) {
            if (x < 16)
                shape.bytes()[static_cast<size_t>(y * 32 + x)] = 255;
            else
                test.at(x, y, 0) = y == 3 ? std::numeric_limits<float>::quiet_NaN() : 7.0f;
        }
    test.at(5, 9, 1) += 0.25f;
    const LinearDifference d = compare_linear(reference, test, 0.1, mask_of(shape));
    EXPECT_EQ(d.not_finite, 0u);
    EXPECT_NEAR(d.failing_fraction, 1.0 / (16 * 32), 1e-12);
    EXPECT_NEAR(d.max_difference, 0.25, 1e-6);
    EXPECT_EQ(d.worst_block_x, 0);
    EXPECT_EQ(d.worst_block_y, 8);
    EXPECT_THROW((void)mask_of(Image(4, 4, 3, Image::Type::u8)), Error);
    EXPECT_THROW((void)compare_linear(reference, test, 0.1, Mask(5, 1)), Error);
}

TEST(CompareLinear, AgreesWithTheScriptOnRealPictures) {
    const std::filesystem::path shared = "../shared/references";  // tests run from the project's root
    if (!std::filesystem::exists(shared)) GTEST_SKIP() << "no " << shared << ": real pictures are not compared";
    // Printed by shared/tools/compare_exr.py for these two files.
    const LinearDifference d = compare_linear(load_image(shared / "s1_fog_spot_single.exr"),
                                              load_image(shared / "s1_fog_spot_multiple_noisy.exr"));
    EXPECT_NEAR(d.relative_mse, 69.70150, 1e-3);
    EXPECT_NEAR(d.psnr_db, 11.82, 0.01);
    EXPECT_NEAR(d.mean_ratio, 2.4339, 1e-4);
    EXPECT_NEAR(d.worst_block, 647.3969, 1e-2);
}

TEST(Flip, IdenticalIsZero) {
    const FlipDifference d = compare_flip(waves(48, 32), waves(48, 32));
    EXPECT_EQ(d.mean, 0);
    EXPECT_EQ(d.max, 0);
}

/// Flat pictures have no features and pass the contrast filters unchanged, so FLIP is the paper's equations on one
/// colour, worked out here by hand.
TEST(Flip, FlatColoursFollowThePaper) {
    // Black and white differ by 100 in lightness; green and blue, the farthest apart in the gamut, by 203.3.
    const FlipDifference d = compare_flip(filled(64, 64, 0, 0, 0), filled(64, 64, 1, 1, 1));
    const double largest = std::pow(203.30165, 0.7);
    const double expected = 0.95 + (std::pow(100.0, 0.7) - 0.4 * largest) / (0.6 * largest) * 0.05;
    EXPECT_NEAR(d.mean, expected, 1e-3);
    EXPECT_NEAR(d.max, expected, 1e-3);
    const FlipDifference farthest = compare_flip(filled(64, 64, 0, 1, 0), filled(64, 64, 0, 0, 1));
    EXPECT_NEAR(farthest.mean, 1, 1e-4);
}

TEST(Flip, IsSymmetric) {
    const Image a = waves(64, 48);
    const Image b = noisy(a, 0.2f);
    EXPECT_NEAR(compare_flip(a, b).mean, compare_flip(b, a).mean, 1e-7);
}

TEST(Flip, GrowsWithTheNoise) {
    const Image image = waves(96, 64);
    double last = 0;
    for (const float amount : {0.02f, 0.05f, 0.1f, 0.2f, 0.4f}) {
        const double mean = compare_flip(image, noisy(image, amount)).mean;
        EXPECT_GT(mean, last);
        EXPECT_LT(mean, 1);
        last = mean;
    }
}

TEST(Flip, FineNoiseVanishesWithDistance) {
    const Image image = filled(96, 64, 0.5f, 0.5f, 0.5f);
    EXPECT_GT(compare_flip(image, noisy(image, 0.1f), 20).mean,
              1.5 * compare_flip(image, noisy(image, 0.1f), 120).mean);
}

TEST(Flip, EdgesCountMoreThanTints) {
    // A one pixel wide line is a feature; the same energy spread out is not.
    const Image grey = filled(96, 96, 0.5f, 0.5f, 0.5f);
    Image line = grey;
    for (int y = 0; y < 96; ++y)
        for (int c = 0; c < 3; ++c) line.at(48, y, c) = 0.9f;
    const FlipDifference d = compare_flip(grey, line);
    EXPECT_GT(d.map.at(48, 48, 0), 0.4f);
    EXPECT_LT(d.map.at(5, 48, 0), 1e-3f);
    EXPECT_EQ(d.worst_block_x, 48);
}

TEST(Flip, RefusesWhatItCannotCompare) {
    Image bad = waves(8, 8);
    EXPECT_THROW((void)compare_flip(waves(8, 8), waves(8, 9)), Error);
    EXPECT_THROW((void)compare_flip(bad, bad, 0), Error);
    bad.at(0, 0, 0) = std::numeric_limits<float>::quiet_NaN();
    EXPECT_THROW((void)compare_flip(waves(8, 8), bad), Error);
}

TEST(HeatMap, RunsFromBlackToPale) {
    Image map(3, 1, 1, Image::Type::f32);
    map.at(1, 0, 0) = 0.5f;
    map.at(2, 0, 0) = 2.0f;
    const Image colours = heat_map(map);
    EXPECT_LT(colours.bytes()[0], 10);
    EXPECT_EQ(colours.bytes()[3], 188);
    EXPECT_EQ(colours.bytes()[6], 252);
}

}  // namespace
}  // namespace tyndall
