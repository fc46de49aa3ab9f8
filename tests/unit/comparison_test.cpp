#include "image/comparison.h"

#include <gtest/gtest.h>

#include <limits>

#include "compare_pictures.h"
#include "core/error.h"
#include "report/entry.h"

namespace tyndall {
namespace {

Image darker(float factor) {
    Image image = waves(48, 32);
    for (float& v : image.floats()) v *= factor;
    return image;
}

TEST(Comparison, AllMetricsOfTheSamePicture) {
    const NoisyPicture picture{waves(48, 32), filled(48, 32, 1e-4f, 1e-4f, 1e-4f)};
    const Comparison same = compare_pictures(picture, picture);
    for (const Metric& metric : metrics_with_limits()) {
        ASSERT_TRUE(same.metrics.contains(metric.name)) << metric.name;
        const double best = metric.at_least ? (std::string(metric.name) == "psnr_db" ? 120 : 1) : 0;
        EXPECT_NEAR(same.metrics.at(metric.name), best, 1e-9) << metric.name;
        EXPECT_TRUE(holds(same, metric, best - (metric.at_least ? 1e-9 : 0))) << metric.name;
    }
    EXPECT_TRUE(same.worst.empty());
}

TEST(Comparison, MetricsFollowTheirDefinitions) {
    const Comparison found = compare_pictures({waves(48, 32), {}}, {darker(0.9f), {}});
    EXPECT_NEAR(found.metrics.at("mean_ratio"), 0.9, 1e-6);
    EXPECT_NEAR(found.metrics.at("mean_error"), 0.1, 1e-6);
    EXPECT_FALSE(found.metrics.contains("z_p")) << "no variance, no Z-test";
    EXPECT_EQ(found.worst.size(), 8u);
    EXPECT_GE(found.worst[0].mean, found.worst[7].mean);
    EXPECT_FALSE(holds(found, metric_called("z_p"), 0.01)) << "what was not measured does not hold";
    EXPECT_TRUE(holds(found, metric_called("mean_error"), 0.11));
    EXPECT_FALSE(holds(found, metric_called("mean_error"), 0.09));
    EXPECT_TRUE(holds(found, metric_called("ssim"), 0.5));
    EXPECT_FALSE(holds(found, metric_called("ssim"), 0.9999));
}

TEST(Comparison, NothingHoldsForNaN) {
    Image bad = waves(48, 32);
    bad.at(7, 5, 1) = std::numeric_limits<float>::quiet_NaN();
    const Comparison found = compare_pictures({waves(48, 32), {}}, {bad, {}});
    EXPECT_FALSE(found.finite);
    for (const Metric& metric : metrics_with_limits())
        EXPECT_FALSE(holds(found, metric, metric.at_least ? -1e9 : 1e9)) << metric.name;
    ASSERT_EQ(found.notes.size(), 1u);
    EXPECT_NE(found.notes[0].find("x 7, y 5"), std::string::npos);
    ComparisonOptions options;
    options.mask.assign(48 * 32, 1);
    options.mask[5 * 48 + 7] = 0;
    EXPECT_TRUE(compare_pictures({waves(48, 32), {}}, {bad, {}}, options).finite) << "masked out";
}

TEST(Comparison, LargerTestsAreFilteredWithTheirVariance) {
    const NoisyPicture reference{waves(48, 32), filled(48, 32, 0, 0, 0)};
    const Image doubled = resize(waves(48, 32), 96, 64);
    Image off = doubled;
    for (float& v : off.floats()) v += 0.01f;
    // Each pixel of the reference is a mean of four: its variance is a quarter, the block's a 256th.
    const Comparison found = compare_pictures(reference, {off, filled(96, 64, 0.0256f, 0.0256f, 0.0256f)});
    EXPECT_NEAR(found.metrics.at("z_worst"), 0.01 / std::sqrt(0.0256 / 256), 1e-3);
    EXPECT_THROW((void)compare_pictures(reference, {waves(96, 63), {}}), Error);
}

TEST(Comparison, UnknownMetricsNameTheNearest) {
    try {
        (void)metric_called("relmsee");
        ADD_FAILURE();
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find("did you mean 'relmse'"), std::string::npos) << error.what();
    }
}

TEST(ReportEntry, IsFilledAndJudged) {
    report::Entry entry;
    entry.name = "darker";
    entry.reference = waves(48, 32);
    entry.test = resize(darker(0.9f), 96, 64);
    (void)report::compare(entry, {}, filled(48, 32, 1e-4f, 1e-4f, 1e-4f));
    EXPECT_EQ(entry.test.width, 48);
    EXPECT_EQ(entry.maps.size(), 4u);
    EXPECT_TRUE(report::hold(entry, "mean_error", 0.2));
    EXPECT_TRUE(entry.held);
    EXPECT_FALSE(report::hold(entry, "z_p", 0.01, "a picture that is 10 % darker is no noise"));
    EXPECT_FALSE(entry.held);
    EXPECT_TRUE(report::hold(entry, "ssim", 0.5));
    EXPECT_FALSE(entry.held) << "once failed, failed";
    EXPECT_EQ(entry.limits.size(), 3u);
}

}  // namespace
}  // namespace tyndall
