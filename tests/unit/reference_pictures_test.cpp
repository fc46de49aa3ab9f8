// The tracer against pictures that independent renderers made of the same scenes (docs/tracing.md).

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

#include "app/engine.h"
#include "core/paths.h"
#include "image/image_io.h"
#include "reference/trace.h"

namespace tyndall {
namespace {

namespace fs = std::filesystem;

constexpr int kBlock = 8;
constexpr double kMeanTolerance = 0.005;    ///< of whole pictures
constexpr double kSignificance = 1e-3;      ///< a right tracer fails so often, for one picture
constexpr double kDarkest = 0.02;           ///< blocks below this share of the mean are left out
constexpr double kPictureTolerance = 5e-4;  ///< relative: where both pictures hardly have noise, rounding differs

fs::path reference_folder() {
    const char* wanted = std::getenv("TYNDALL_REFERENCES");
    return wanted ? fs::path(wanted) : paths::root().parent_path() / "shared" / "references";
}

/// |z| that one of `count` normal numbers passes with probability `significance`.
double critical(double significance, double count) {
    const double tail = 1.0 - std::pow(1.0 - significance, 1.0 / count);
    double low = 0.0, high = 12.0;
    for (int i = 0; i < 60; ++i) {
        const double middle = 0.5 * (low + high);
        (std::erfc(middle / std::sqrt(2.0)) > tail ? low : high) = middle;
    }
    return low;
}

/// Mean of the differences of a block's 64 pixels over its standard error. Their scatter holds the noise of both
/// pictures, so nothing needs to be assumed of either.
struct BlockScore {
    double z = 0.0, reference = 0.0;
};

BlockScore score(const Image& reference, const Image& test, int x0, int y0, int channel) {
    constexpr double kCount = kBlock * kBlock;
    double sum = 0.0, squares = 0.0, level = 0.0;
    for (int y = y0; y < y0 + kBlock; ++y)
        for (int x = x0; x < x0 + kBlock; ++x) {
            const double r = static_cast<double>(reference.at(x, y, channel));
            const double d = static_cast<double>(test.at(x, y, channel)) - r;
            sum += d, squares += d * d, level += r;
        }
    const double mean = sum / kCount,
                 variance = std::max(0.0, squares / kCount - mean * mean) * kCount / (kCount - 1.0);
    const double rounding = kPictureTolerance * level / kCount;
    return {mean / std::sqrt(variance / kCount + rounding * rounding), level / kCount};
}

struct Picture {
    const char* name;
    const char* reference;
    const char* scene;
    glm::ivec2 size;
    int samples;
    bool single;
    double block_tolerance = 0.0;  ///< relative bias of the reference itself, where its makers state one
};

void PrintTo(const Picture& picture, std::ostream* out) {
    *out << picture.name;
}

class ReferencePicture : public testing::TestWithParam<Picture> {};

TEST_P(ReferencePicture, IsWhatIndependentRenderersFound) {
    const Picture& picture = GetParam();
    const fs::path file = reference_folder() / picture.reference;
    if (!fs::exists(file))
        GTEST_SKIP() << "no " << file << ": TYNDALL_REFERENCES names the folder of reference pictures";
    const Image reference = with_channels(load_image(file), 3);
    Engine engine(false);
    engine.load_scene(paths::root() / "assets" / "scenes" / picture.scene);
    reference::TraceSettings settings;
    settings.size = picture.size;
    settings.batch = std::min(picture.samples, 256);
    if (picture.single) settings.max_order = 1;
    const Image test = reference::trace(engine.extract(), settings, picture.samples).radiance();

    double means[2][3] = {}, worst = 0.0, squares = 0.0;
    int count = 0;
    for (int c = 0; c < 3; ++c) {
        for (int y = 0; y < reference.height; ++y)
            for (int x = 0; x < reference.width; ++x) {
                means[0][c] += static_cast<double>(reference.at(x, y, c));
                means[1][c] += static_cast<double>(test.at(x, y, c));
            }
        const double dark = kDarkest * means[0][c] / (static_cast<double>(reference.width) * reference.height);
        for (int y = 0; y + kBlock <= reference.height; y += kBlock)
            for (int x = 0; x + kBlock <= reference.width; x += kBlock) {
                const BlockScore block = score(reference, test, x, y, c);
                if (block.reference <= dark) continue;
                worst = std::max(worst, std::abs(block.z));
                squares += block.z * block.z;
                ++count;
            }
    }
    // a t distribution with 63 degrees of freedom has slightly wider tails than the normal one: Cornish-Fisher's term
    const double normal = critical(kSignificance, count),
                 limit = normal + (std::pow(normal, 3.0) + normal) / (4.0 * 63.0);
    fmt::print(
        "{}: means {:.4f} {:.4f} {:.4f} of the reference's; {} blocks, root mean square z {:.3f}, largest {:.2f} "
        "(limit {:.2f})\n",
        picture.name, means[1][0] / means[0][0], means[1][1] / means[0][1], means[1][2] / means[0][2], count,
        std::sqrt(squares / count), worst, limit);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(means[1][c] / means[0][c], 1.0, kMeanTolerance) << "channel " << c;
    EXPECT_GT(count, 100);
    EXPECT_LT(worst, limit);
}

INSTANTIATE_TEST_SUITE_P(
    All, ReferencePicture,
    testing::Values(Picture{"fog_single", "s1_fog_spot_single.exr", "s1_fog_spot.json", {320, 180}, 128, true},
                    Picture{
                        "fog_multiple", "s1_fog_spot_multiple_noisy.exr", "s1_fog_spot.json", {320, 180}, 64, false},
                    Picture{"potato_matched",
                            "s3_sphere_potato_side_matched.exr",
                            "s3_sphere_potato_matched.json",
                            {192, 192},
                            128,
                            false},
                    Picture{"marble_matched",
                            "s3_sphere_marble_side_matched.exr",
                            "s3_sphere_marble_matched.json",
                            {192, 192},
                            256,
                            false},
                    Picture{"potato_dielectric",
                            "s3_sphere_potato_side_dielectric.exr",
                            "s3_sphere_potato_dielectric.json",
                            {96, 96},
                            2048,
                            false},
                    Picture{"cloud_single", "s4_hetero_single.exr", "s4_hetero.json", {256, 256}, 64, true}),
    [](const auto& info) { return info.param.name; });

}  // namespace
}  // namespace tyndall
