#include "image/significance.h"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/special_functions/gamma.hpp>
#include <cmath>
#include <limits>

#include "core/error.h"

namespace tyndall {
namespace {

constexpr int kBlock = 8;
/// Blocks without noise are the same when they agree to this part of their mean: what rounding leaves.
constexpr double kExact = 1e-5;

double two_sided_p(double z) {
    return std::erfc(std::abs(z) / std::sqrt(2.0));
}

void check(const Image& image, const Image& like, const char* what, bool variance, const Mask& mask) {
    if (image.width != like.width || image.height != like.height || image.channels != 3 ||
        image.type != Image::Type::f32)
        throw Error(fmt::format("the {} is not of the reference's size and three channels", what));
    const auto values = image.floats();
    for (size_t i = 0; i < values.size(); ++i) {
        if ((std::isfinite(values[i]) && !(variance && values[i] < 0)) || (!mask.empty() && mask[i / 3] == 0)) continue;
        const auto width = static_cast<size_t>(image.width);
        throw Error(Diagnostic{{},
                               fmt::format("the {} is {} at x {}, y {}", what, values[i], i / 3 % width, i / 3 / width),
                               variance ? "a finite number, not below 0; a trace of a single batch has no variance yet"
                                        : "a finite number"});
    }
}

/// Sums over a block, or over the whole picture, of one channel.
struct Sums {
    double difference = 0, size = 0, variance = 0;
    size_t count = 0;

    void add(const Sums& other) {
        difference += other.difference;
        size += other.size;
        variance += other.variance;
        count += other.count;
    }
    [[nodiscard]] bool exact() const { return variance <= 0; }
    [[nodiscard]] bool differs() const { return std::abs(difference) > kExact * size; }
    [[nodiscard]] double z() const { return difference / std::sqrt(variance); }
};

/// Goes over the blocks of one channel.
class Channel {
 public:
    Channel(const NoisyPicture& reference, const NoisyPicture& test, const Mask& mask, int channel)
        : reference_(reference), test_(test), mask_(mask), channel_(channel) {}

    [[nodiscard]] Sums block(int left, int top) const {
        Sums sums;
        const Image& r = reference_.radiance;
        for (int y = top; y < std::min(top + kBlock, r.height); ++y)
            for (int x = left; x < std::min(left + kBlock, r.width); ++x) {
                const auto pixel = static_cast<size_t>(y) * static_cast<size_t>(r.width) + static_cast<size_t>(x);
                if (!mask_.empty() && mask_[pixel] == 0) continue;
                const size_t i = 3 * pixel + static_cast<size_t>(channel_);
                const auto at = [i](const Image& image) { return static_cast<double>(image.floats()[i]); };
                sums.difference += at(test_.radiance) - at(r);
                sums.size += std::abs(at(r));
                sums.variance += at(test_.variance) + at(reference_.variance);
                ++sums.count;
            }
        return sums;
    }

 private:
    const NoisyPicture& reference_;
    const NoisyPicture& test_;
    const Mask& mask_;
    int channel_;
};

void paint(Image& map, int left, int top, double z) {
    for (int y = top; y < std::min(top + kBlock, map.height); ++y)
        for (int x = left; x < std::min(left + kBlock, map.width); ++x)
            map.at(x, y, 0) = std::max(map.at(x, y, 0), static_cast<float>(std::abs(z)));
}

/// Adds one channel's blocks to the outcome, and judges its spread and its mean.
void add_channel(ZTest& result, const Channel& channel, int number, size_t& above) {
    Sums whole;
    double squares = 0;
    size_t tests = 0;
    for (int y = 0; y < result.map.height; y += kBlock)
        for (int x = 0; x < result.map.width; x += kBlock) {
            const Sums sums = channel.block(x, y);
            whole.add(sums);
            if (sums.count == 0 || (sums.exact() && !sums.differs())) continue;
            const double z =
                sums.exact() ? std::copysign(std::numeric_limits<double>::infinity(), sums.difference) : sums.z();
            if (sums.exact())
                ++result.exact_differences;
            else
                squares += z * z, ++tests;
            if (std::abs(z) > result.critical) ++above;
            paint(result.map, x, y, z);
            if (std::abs(z) <= std::abs(result.worst)) continue;
            result.worst = z;
            result.worst_x = x;
            result.worst_y = y;
            result.worst_channel = number;
        }
    result.tests += tests;
    if (tests == 0) return;
    const double mean_square = squares / static_cast<double>(tests);
    result.mean_square = std::max(result.mean_square, mean_square);
    const double spread_p = boost::math::gamma_q(static_cast<double>(tests) / 2, squares / 2);
    result.spread_p = std::min({result.spread_p, 3 * spread_p, 1.0});
    if (std::abs(whole.z()) > std::abs(result.mean_z)) result.mean_z = whole.z();
    result.mean_p = std::min({result.mean_p, 3 * two_sided_p(whole.z()), 1.0});
}

}  // namespace

ZTest z_test(const NoisyPicture& reference, const NoisyPicture& test, double significance, const Mask& mask) {
    check(reference.radiance, reference.radiance, "reference picture", false, mask);
    check(reference.variance, reference.radiance, "reference's variance", true, mask);
    check(test.radiance, reference.radiance, "test picture", false, mask);
    check(test.variance, reference.radiance, "test's variance", true, mask);
    if (!(significance > 0 && significance < 1)) throw Error("a significance lies between 0 and 1, such as 0.01");
    ZTest result;
    result.critical = boost::math::quantile(boost::math::complement(boost::math::normal(), significance / 2));
    result.map = Image(reference.radiance.width, reference.radiance.height, 1, Image::Type::f32);
    size_t above = 0;
    for (int c = 0; c < 3; ++c) add_channel(result, Channel(reference, test, mask, c), c, above);
    const auto all = static_cast<double>(result.tests + result.exact_differences);
    if (all > 0) result.share_above = static_cast<double>(above) / all;
    // 1 - (1 - p)^n without losing small p.
    if (result.tests > 0)
        result.worst_p = -std::expm1(static_cast<double>(result.tests) * std::log1p(-two_sided_p(result.worst)));
    if (result.exact_differences > 0) result.worst_p = 0;
    result.p = std::min(1.0, 3 * std::min({result.worst_p, result.spread_p, result.mean_p}));
    return result;
}

Image variance_of_relative_noise(const Image& radiance, double noise) {
    Image variance = radiance;
    for (float& v : variance.floats()) v = static_cast<float>(std::pow(noise * static_cast<double>(v), 2));
    return variance;
}

}  // namespace tyndall
