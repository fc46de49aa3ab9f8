// Structural similarity: Z. Wang, A. C. Bovik, H. R. Sheikh, E. P. Simoncelli, "Image Quality Assessment: From Error
// Visibility to Structural Similarity", IEEE Transactions on Image Processing 13(4), 2004.
#include <algorithm>
#include <array>
#include <cmath>

#include "core/error.h"
#include "core/parallel.h"
#include "image/compare.h"

namespace tyndall {
namespace {

constexpr int kRadius = 5;
constexpr double kDeviation = 1.5;
constexpr double kC1 = 0.01 * 0.01, kC2 = 0.03 * 0.03;  // (K L)^2 for a dynamic range L of 1
constexpr size_t kRowsAtOnce = 16;

using Plane = std::vector<double>;
using Kernel = std::array<double, 2 * kRadius + 1>;

Kernel gaussian() {
    Kernel kernel;
    double sum = 0;
    for (int i = -kRadius; i <= kRadius; ++i)
        sum += kernel[static_cast<size_t>(i + kRadius)] = std::exp(-i * i / (2 * kDeviation * kDeviation));
    for (double& v : kernel) v /= sum;
    return kernel;
}

struct Size {
    int width, height;
    [[nodiscard]] size_t at(int x, int y) const {
        return static_cast<size_t>(y) * static_cast<size_t>(width) + static_cast<size_t>(x);
    }
};

/// One pass of the window's mean; where it hangs over the border, over what is inside.
Plane averaged(const Plane& in, Size size, bool along_x) {
    static const Kernel kKernel = gaussian();
    Plane out(in.size());
    parallel_for(0, static_cast<size_t>(size.height), kRowsAtOnce, [&](size_t first, size_t last) {
        for (int y = static_cast<int>(first); y < static_cast<int>(last); ++y)
            for (int x = 0; x < size.width; ++x) {
                double sum = 0, weight = 0;
                for (int k = -kRadius; k <= kRadius; ++k) {
                    const int u = along_x ? x + k : x, v = along_x ? y : y + k;
                    if (u < 0 || v < 0 || u >= size.width || v >= size.height) continue;
                    const double w = kKernel[static_cast<size_t>(k + kRadius)];
                    sum += w * in[size.at(u, v)];
                    weight += w;
                }
                out[size.at(x, y)] = sum / weight;
            }
    });
    return out;
}

Plane averaged(const Plane& in, Size size) {
    return averaged(averaged(in, size, true), size, false);
}

Plane product(const Plane& a, const Plane& b) {
    Plane out(a.size());
    std::ranges::transform(a, b, out.begin(), [](double x, double y) { return x * y; });
    return out;
}

Plane luma(const Image& encoded) {
    const Image rgb = to_float(with_channels(encoded, 3));
    Plane out(rgb.value_count() / 3);
    const auto v = rgb.floats();
    for (size_t i = 0; i < out.size(); ++i) {
        const auto value = [&](size_t c) { return std::clamp(static_cast<double>(v[3 * i + c]), 0.0, 1.0); };
        out[i] = 0.2126 * value(0) + 0.7152 * value(1) + 0.0722 * value(2);
        if (std::isnan(v[3 * i] + v[3 * i + 1] + v[3 * i + 2])) throw Error("a picture to compare holds NaN");
    }
    return out;
}

/// The equation of the paper, at every pixel.
Plane similarity(const Plane& r, const Plane& t, Size size) {
    const Plane r_mean = averaged(r, size), t_mean = averaged(t, size);
    const Plane rr = averaged(product(r, r), size), tt = averaged(product(t, t), size);
    const Plane rt = averaged(product(r, t), size);
    Plane out(r.size());
    for (size_t i = 0; i < out.size(); ++i) {
        const double r2 = r_mean[i] * r_mean[i], t2 = t_mean[i] * t_mean[i], cross = r_mean[i] * t_mean[i];
        out[i] = (2 * cross + kC1) * (2 * (rt[i] - cross) + kC2) /
                 ((r2 + t2 + kC1) * (std::max(rr[i] - r2, 0.0) + std::max(tt[i] - t2, 0.0) + kC2));
    }
    return out;
}

}  // namespace

SsimDifference compare_ssim(const Image& reference, const Image& test, const Mask& mask) {
    if (reference.width != test.width || reference.height != test.height || reference.empty() ||
        reference.channels < 3 || test.channels < 3)
        throw Error("SSIM compares pictures of the same size and at least 3 channels");
    const Size size{reference.width, reference.height};
    const Plane values = similarity(luma(reference), luma(test), size);
    SsimDifference result;
    result.map = Image(size.width, size.height, 1, Image::Type::f32);
    const int border_x = size.width > 2 * kRadius ? kRadius : 0, border_y = size.height > 2 * kRadius ? kRadius : 0;
    double sum = 0;
    size_t count = 0;
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            const int u = std::clamp(x, border_x, size.width - 1 - border_x);
            const int v = std::clamp(y, border_y, size.height - 1 - border_y);
            const double value = values[size.at(u, v)];
            result.map.at(x, y, 0) = static_cast<float>(value);
            if (u != x || v != y || (!mask.empty() && mask[size.at(x, y)] == 0)) continue;
            sum += value;
            result.worst = std::min(result.worst, value);
            ++count;
        }
    if (count > 0) result.mean = sum / static_cast<double>(count);
    return result;
}

}  // namespace tyndall
