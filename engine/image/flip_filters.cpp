#include "image/flip_filters.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/parallel.h"

namespace tyndall::flip {
namespace {

constexpr float kPi = std::numbers::pi_v<float>;
constexpr float kW = 0.082f;  // width of the feature detector in degrees
constexpr size_t kRowsAtOnce = 32;

/// out[i] += weight * in[i].
void add_weighted(float* out, const float* in, float weight, int count) {
    for (int i = 0; i < count; ++i) out[i] += weight * in[i];
}

/// One pass of a separable filter along x; kernel[radius] is its middle.
Plane along_x(const Plane& in, Extent extent, const std::vector<float>& kernel) {
    const size_t radius = kernel.size() / 2, width = static_cast<size_t>(extent.width);
    Plane out(in.size(), 0.0f);
    parallel_for(0, static_cast<size_t>(extent.height), kRowsAtOnce, [&](size_t first, size_t last) {
        std::vector<float> padded(width + 2 * radius);
        for (size_t y = first; y < last; ++y) {
            const float* row = &in[y * width];
            std::fill_n(padded.begin(), radius, row[0]);
            std::copy_n(row, width, &padded[radius]);
            std::fill_n(&padded[radius + width], radius, row[width - 1]);
            for (size_t k = 0; k < kernel.size(); ++k)
                add_weighted(&out[y * width], &padded[k], kernel[k], extent.width);
        }
    });
    return out;
}

/// The same along y.
Plane along_y(const Plane& in, Extent extent, const std::vector<float>& kernel) {
    const int radius = static_cast<int>(kernel.size() / 2);
    const auto width = static_cast<size_t>(extent.width);
    Plane out(in.size(), 0.0f);
    parallel_for(0, static_cast<size_t>(extent.height), kRowsAtOnce, [&](size_t first, size_t last) {
        for (size_t y = first; y < last; ++y)
            for (int k = -radius; k <= radius; ++k) {
                const int from = std::clamp(static_cast<int>(y) + k, 0, extent.height - 1);
                add_weighted(&out[y * width], &in[static_cast<size_t>(from) * width],
                             kernel[static_cast<size_t>(k + radius)], extent.width);
            }
    });
    return out;
}

/// Positive weights are scaled to sum to 1 and negative ones to -1.
void balance(std::vector<float>& kernel) {
    float positive = 0, negative = 0;
    for (const float v : kernel) (v > 0 ? positive : negative) += v;
    for (float& v : kernel) v /= v > 0 ? positive : -negative;
}

}  // namespace

Plane contrast_filtered(const Plane& in, Extent extent, std::initializer_list<Sensitivity> terms, float ppd) {
    constexpr float kWidest = 0.04f;
    const int radius = static_cast<int>(std::ceil(3 * std::sqrt(kWidest / (2 * kPi * kPi)) * ppd));
    Plane out(in.size(), 0.0f);
    float total = 0;
    for (const auto [a, b] : terms) {
        std::vector<float> kernel;
        float sum = 0;
        for (int i = -radius; i <= radius; ++i) {
            const float degrees = static_cast<float>(i) / ppd;
            sum += kernel.emplace_back(std::exp(-kPi * kPi * degrees * degrees / b));
        }
        const float weight = a * std::sqrt(kPi / b);
        total += weight * sum * sum;
        const Plane part = along_y(along_x(in, extent, kernel), extent, kernel);
        for (size_t i = 0; i < out.size(); ++i) out[i] += weight * part[i];
    }
    for (float& v : out) v /= total;
    return out;
}

Features features_of(const Plane& lightness, Extent extent, float ppd) {
    const float deviation = 0.5f * kW * ppd;
    const int radius = static_cast<int>(std::ceil(3 * deviation));
    std::vector<float> smooth, edge, point;
    float sum = 0;
    for (int i = -radius; i <= radius; ++i) {
        const float x = static_cast<float>(i);
        const float g = std::exp(-x * x / (2 * deviation * deviation));
        sum += smooth.emplace_back(g);
        edge.push_back(-x * g);
        point.push_back((x * x / (deviation * deviation) - 1) * g);
    }
    for (float& v : smooth) v /= sum;
    balance(edge);
    balance(point);

    const Plane smooth_x = along_x(lightness, extent, smooth);
    const Plane smooth_y = along_y(lightness, extent, smooth);
    const auto magnitude = [&](const std::vector<float>& kernel) {
        Plane x = along_x(smooth_y, extent, kernel);
        const Plane y = along_y(smooth_x, extent, kernel);
        for (size_t i = 0; i < x.size(); ++i) x[i] = std::hypot(x[i], y[i]);
        return x;
    };
    return {magnitude(edge), magnitude(point)};
}

}  // namespace tyndall::flip
