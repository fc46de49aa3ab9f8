// LDR-FLIP, written from the paper: P. Andersson, J. Nilsson, T. Akenine-Moeller, M. Oskarsson, K. Astrom, M. D.
// Fairchild, "FLIP: A Difference Evaluator for Alternating Images", Proc. ACM Comput. Graph. Interact. Tech. 3(2),
// 2020. Names of constants follow it.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <numbers>

#include "core/error.h"
#include "image/blocks.h"
#include "image/compare.h"

namespace tyndall {
namespace {

constexpr float kPi = std::numbers::pi_v<float>;
constexpr float kQc = 0.7f;  // exponent of the colour difference
constexpr float kPc = 0.4f;  // share of the largest difference that is mapped to [0, kPt]
constexpr float kPt = 0.95f;
constexpr float kQf = 0.5f;   // exponent of the feature difference
constexpr float kW = 0.082f;  // width of the feature detector in degrees

using Plane = std::vector<float>;
using Colours = std::vector<glm::vec3>;

/// Linear sRGB to XYZ (IEC 61966-2-1); columns.
const glm::mat3 kToXyz(0.41238657f, 0.21263682f, 0.01933060f, 0.35759150f, 0.71518300f, 0.11919716f, 0.18045051f,
                       0.07218020f, 0.95037259f);
const glm::mat3 kFromXyz = glm::inverse(kToXyz);
const glm::vec3 kWhite = kToXyz * glm::vec3(1.0f);

glm::vec3 linear_from_srgb(glm::vec3 c) {
    const auto decode = [](float v) { return v > 0.04045f ? std::pow((v + 0.055f) / 1.055f, 2.4f) : v / 12.92f; };
    return {decode(c.x), decode(c.y), decode(c.z)};
}

/// The linearised CIELAB in which the eye's contrast filters work.
glm::vec3 ycxcz_from_linear(glm::vec3 rgb) {
    const glm::vec3 xyz = kToXyz * rgb / kWhite;
    return {116 * xyz.y - 16, 500 * (xyz.x - xyz.y), 200 * (xyz.y - xyz.z)};
}

glm::vec3 linear_from_ycxcz(glm::vec3 c) {
    const float y = (c.x + 16) / 116;
    return kFromXyz * (glm::vec3(y + c.y / 500, y, y - c.z / 200) * kWhite);
}

/// CIELAB with Hunt's effect: chroma grows with lightness.
glm::vec3 hunt_lab_from_linear(glm::vec3 rgb) {
    const auto f = [](float t) {
        constexpr float kDelta = 6.0f / 29.0f;
        return t > kDelta * kDelta * kDelta ? std::cbrt(t) : t / (3 * kDelta * kDelta) + 4.0f / 29.0f;
    };
    const glm::vec3 xyz = kToXyz * rgb / kWhite;
    const float x = f(xyz.x), y = f(xyz.y), z = f(xyz.z);
    const float lightness = 116 * y - 16;
    const float hunt = 0.01f * lightness;
    return {lightness, hunt * 500 * (x - y), hunt * 200 * (y - z)};
}

/// City-block distance in lightness, Euclidean in chroma.
float hyab(glm::vec3 a, glm::vec3 b) {
    const glm::vec3 d = a - b;
    return std::abs(d.x) + std::sqrt(d.y * d.y + d.z * d.z);
}

/// A picture's width and height, for filters that repeat the border.
struct Extent {
    int width = 0;
    int height = 0;
};

/// One pass of a separable filter along x or y; kernel[radius] is its middle.
Plane filtered(const Plane& in, Extent extent, const std::vector<float>& kernel, bool along_x) {
    const int radius = static_cast<int>(kernel.size() / 2);
    const int length = along_x ? extent.width : extent.height;
    const size_t step = along_x ? 1 : static_cast<size_t>(extent.width);
    Plane out(in.size());
    for (int y = 0; y < extent.height; ++y)
        for (int x = 0; x < extent.width; ++x) {
            const int at = along_x ? x : y;
            const size_t index = static_cast<size_t>(y) * static_cast<size_t>(extent.width) + static_cast<size_t>(x);
            const size_t line = index - static_cast<size_t>(at) * step;
            float sum = 0;
            for (int k = -radius; k <= radius; ++k)
                sum += kernel[static_cast<size_t>(k + radius)] *
                       in[line + static_cast<size_t>(std::clamp(at + k, 0, length - 1)) * step];
            out[index] = sum;
        }
    return out;
}

Plane filtered(const Plane& in, Extent extent, const std::vector<float>& x_kernel, const std::vector<float>& y_kernel) {
    return filtered(filtered(in, extent, x_kernel, true), extent, y_kernel, false);
}

/// One Gaussian of a contrast sensitivity function: a sqrt(pi/b) exp(-pi^2 d^2 / b), d in degrees.
struct Sensitivity {
    float a, b;
};

/// Filters one channel by a sum of Gaussians whose weights, over the square kernel, sum to 1.
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
        const Plane part = filtered(in, extent, kernel, kernel);
        for (size_t i = 0; i < out.size(); ++i) out[i] += weight * part[i];
    }
    for (float& v : out) v /= total;
    return out;
}

Plane channel(const Colours& colours, int c) {
    Plane plane(colours.size());
    std::ranges::transform(colours, plane.begin(), [c](const glm::vec3& v) { return v[c]; });
    return plane;
}

/// What the eye resolves of a picture (in YCxCz) at this distance, in Hunt-adjusted Lab.
Colours perceived(const Colours& ycxcz, Extent extent, float ppd) {
    const Plane a = contrast_filtered(channel(ycxcz, 0), extent, {{1, 0.0047f}}, ppd);
    const Plane rg = contrast_filtered(channel(ycxcz, 1), extent, {{1, 0.0053f}}, ppd);
    const Plane by = contrast_filtered(channel(ycxcz, 2), extent, {{34.1f, 0.04f}, {13.5f, 0.025f}}, ppd);
    Colours out(ycxcz.size());
    for (size_t i = 0; i < out.size(); ++i)
        out[i] =
            hunt_lab_from_linear(glm::clamp(linear_from_ycxcz({a[i], rg[i], by[i]}), glm::vec3(0.0f), glm::vec3(1.0f)));
    return out;
}

/// Positive weights are scaled to sum to 1 and negative ones to -1.
void balance(std::vector<float>& kernel) {
    float positive = 0, negative = 0;
    for (const float v : kernel) (v > 0 ? positive : negative) += v;
    for (float& v : kernel) v /= v > 0 ? positive : -negative;
}

struct Features {
    Plane edges, points;  ///< magnitudes of the first and second derivative of the lightness
};

Features features_of(const Colours& ycxcz, Extent extent, float ppd) {
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

    Plane lightness = channel(ycxcz, 0);
    for (float& v : lightness) v = (v + 16) / 116;
    const Plane smooth_x = filtered(lightness, extent, smooth, true);
    const Plane smooth_y = filtered(lightness, extent, smooth, false);
    const auto magnitude = [&](const std::vector<float>& kernel) {
        Plane along_x = filtered(smooth_y, extent, kernel, true);
        const Plane along_y = filtered(smooth_x, extent, kernel, false);
        for (size_t i = 0; i < along_x.size(); ++i) along_x[i] = std::hypot(along_x[i], along_y[i]);
        return along_x;
    };
    return {magnitude(edge), magnitude(point)};
}

/// Compresses large colour differences into [kPt, 1], since they all look "different".
float redistributed(float difference, float largest) {
    const float knee = kPc * largest;
    if (difference < knee) return difference * kPt / knee;
    return std::min(kPt + (difference - knee) / (largest - knee) * (1 - kPt), 1.0f);
}

Colours ycxcz_of(const Image& image) {
    const Image rgb = to_float(with_channels(image, 3));
    Colours out(rgb.floats().size() / 3);
    for (size_t i = 0; i < out.size(); ++i) {
        const glm::vec3 c(rgb.floats()[3 * i], rgb.floats()[3 * i + 1], rgb.floats()[3 * i + 2]);
        if (c != c) throw Error("a picture to compare holds NaN");
        out[i] = ycxcz_from_linear(linear_from_srgb(glm::clamp(c, glm::vec3(0.0f), glm::vec3(1.0f))));
    }
    return out;
}

}  // namespace

FlipDifference compare_flip(const Image& reference, const Image& test, float pixels_per_degree) {
    if (reference.width != test.width || reference.height != test.height)
        throw Error("FLIP compares pictures of the same size");
    if (reference.empty() || reference.channels < 3 || test.channels < 3 || !(pixels_per_degree > 0))
        throw Error("FLIP compares pictures of at least 3 channels at a positive number of pixels per degree");
    const Extent extent{reference.width, reference.height};
    const Colours r = ycxcz_of(reference);
    const Colours t = ycxcz_of(test);
    const Colours r_seen = perceived(r, extent, pixels_per_degree);
    const Colours t_seen = perceived(t, extent, pixels_per_degree);
    const Features r_features = features_of(r, extent, pixels_per_degree);
    const Features t_features = features_of(t, extent, pixels_per_degree);
    // The largest colour difference in the sRGB gamut is that between green and blue.
    const float largest = std::pow(hyab(hunt_lab_from_linear({0, 1, 0}), hunt_lab_from_linear({0, 0, 1})), kQc);

    FlipDifference result;
    result.map = Image(extent.width, extent.height, 1, Image::Type::f32);
    const std::span<float> map = result.map.floats();
    double sum = 0;
    for (size_t i = 0; i < map.size(); ++i) {
        const float colour = redistributed(std::pow(hyab(r_seen[i], t_seen[i]), kQc), largest);
        const float edge = std::abs(r_features.edges[i] - t_features.edges[i]);
        const float point = std::abs(r_features.points[i] - t_features.points[i]);
        const float feature = std::pow(std::max(edge, point) / std::numbers::sqrt2_v<float>, kQf);
        map[i] = std::pow(colour, 1 - std::min(feature, 1.0f));
        sum += static_cast<double>(map[i]);
    }
    result.mean = sum / static_cast<double>(map.size());
    result.max = static_cast<double>(std::ranges::max(map));
    const Block worst = worst_block(map, extent.width, extent.height);
    result.worst_block = worst.mean;
    result.worst_block_x = worst.x;
    result.worst_block_y = worst.y;
    return result;
}

Image heat_map(const Image& map) {
    constexpr glm::vec3 kRamp[] = {{0, 0, 4}, {87, 16, 110}, {188, 55, 84}, {249, 142, 9}, {252, 255, 164}};
    Image out(map.width, map.height, 3, Image::Type::u8);
    for (size_t i = 0; i < map.floats().size(); ++i) {
        const float v = map.floats()[i * static_cast<size_t>(map.channels)];
        const float at = 4 * (v > 0 ? std::min(v, 1.0f) : 0.0f);
        const auto low = std::min(static_cast<size_t>(at), size_t{3});
        const glm::vec3 colour = glm::mix(kRamp[low], kRamp[low + 1], at - static_cast<float>(low));
        for (size_t c = 0; c < 3; ++c)
            out.bytes()[3 * i + c] = static_cast<std::uint8_t>(std::lround(colour[static_cast<int>(c)]));
    }
    return out;
}

}  // namespace tyndall
