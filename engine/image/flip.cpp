// LDR-FLIP, written from the paper: P. Andersson, J. Nilsson, T. Akenine-Moeller, M. Oskarsson, K. Astrom, M. D.
// Fairchild, "FLIP: A Difference Evaluator for Alternating Images", Proc. ACM Comput. Graph. Interact. Tech. 3(2),
// 2020. Names of constants follow it.
#include "image/flip.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <numbers>

#include "core/error.h"
#include "core/parallel.h"
#include "image/blocks.h"
#include "image/flip_filters.h"

namespace tyndall {
namespace flip {
namespace {

constexpr float kQc = 0.7f;  // exponent of the colour difference
constexpr float kPc = 0.4f;  // share of the largest difference that is mapped to [0, kPt]
constexpr float kPt = 0.95f;
constexpr float kQf = 0.5f;  // exponent of the feature difference
constexpr size_t kPixelsAtOnce = 4096;

using Colours = std::vector<glm::vec3>;

/// Linear sRGB to XYZ (IEC 61966-2-1); columns.
const glm::mat3 kToXyz(0.41238657f, 0.21263682f, 0.01933060f, 0.35759150f, 0.71518300f, 0.11919716f, 0.18045051f,
                       0.07218020f, 0.95037259f);
const glm::mat3 kFromXyz = glm::inverse(kToXyz);
const glm::vec3 kWhite = kToXyz * glm::vec3(1.0f);

float linear_from_srgb(float v) {
    return v > 0.04045f ? std::pow((v + 0.055f) / 1.055f, 2.4f) : v / 12.92f;
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
    parallel_for(0, out.size(), kPixelsAtOnce, [&](size_t first, size_t last) {
        for (size_t i = first; i < last; ++i)
            out[i] = hunt_lab_from_linear(
                glm::clamp(linear_from_ycxcz({a[i], rg[i], by[i]}), glm::vec3(0.0f), glm::vec3(1.0f)));
    });
    return out;
}

/// Compresses large colour differences into [kPt, 1], since they all look "different".
float redistributed(float difference, float largest) {
    const float knee = kPc * largest;
    if (difference < knee) return difference * kPt / knee;
    return std::min(kPt + (difference - knee) / (largest - knee) * (1 - kPt), 1.0f);
}

/// What FLIP asks of one picture.
struct Seen {
    Colours colours;
    Features features;

    Seen(const Image& linear, Extent extent, float ppd) {
        const auto rgb = linear.floats();
        Colours ycxcz(rgb.size() / 3);
        for (size_t i = 0; i < ycxcz.size(); ++i)
            ycxcz[i] = ycxcz_from_linear({rgb[3 * i], rgb[3 * i + 1], rgb[3 * i + 2]});
        colours = perceived(ycxcz, extent, ppd);
        Plane lightness = channel(ycxcz, 0);
        for (float& v : lightness) v = (v + 16) / 116;
        features = features_of(lightness, extent, ppd);
    }
};

Image linear_of(const Image& encoded) {
    Image rgb = to_float(with_channels(encoded, 3));
    for (float& v : rgb.floats()) {
        if (std::isnan(v)) throw Error("a picture to compare holds NaN");
        v = linear_from_srgb(std::clamp(v, 0.0f, 1.0f));
    }
    return rgb;
}

}  // namespace

void check(const Image& reference, const Image& test, float pixels_per_degree) {
    if (reference.width != test.width || reference.height != test.height)
        throw Error("FLIP compares pictures of the same size");
    if (reference.empty() || reference.channels < 3 || test.channels < 3 || !(pixels_per_degree > 0))
        throw Error("FLIP compares pictures of at least 3 channels at a positive number of pixels per degree");
}

Image map_of(const Image& reference, const Image& test, float pixels_per_degree) {
    const Extent extent{reference.width, reference.height};
    const Seen r(reference, extent, pixels_per_degree), t(test, extent, pixels_per_degree);
    // The largest colour difference in the sRGB gamut is that between green and blue.
    const float largest = std::pow(hyab(hunt_lab_from_linear({0, 1, 0}), hunt_lab_from_linear({0, 0, 1})), kQc);
    Image map(extent.width, extent.height, 1, Image::Type::f32);
    const std::span<float> out = map.floats();
    parallel_for(0, out.size(), kPixelsAtOnce, [&](size_t first, size_t last) {
        for (size_t i = first; i < last; ++i) {
            const float colour = redistributed(std::pow(hyab(r.colours[i], t.colours[i]), kQc), largest);
            const float edge = std::abs(r.features.edges[i] - t.features.edges[i]);
            const float point = std::abs(r.features.points[i] - t.features.points[i]);
            const float feature = std::pow(std::max(edge, point) / std::numbers::sqrt2_v<float>, kQf);
            out[i] = std::pow(colour, 1 - std::min(feature, 1.0f));
        }
    });
    return map;
}

FlipDifference pooled(Image map, const Mask& mask) {
    FlipDifference result;
    result.map = std::move(map);
    const auto values = std::as_const(result.map).floats();
    double sum = 0;
    size_t count = 0;
    for (size_t i = 0; i < values.size(); ++i) {
        if (!mask.empty() && mask[i] == 0) continue;
        sum += static_cast<double>(values[i]);
        result.max = std::max(result.max, static_cast<double>(values[i]));
        ++count;
    }
    result.mean = count > 0 ? sum / static_cast<double>(count) : 0;
    const Block worst = worst_block(values, result.map.width, result.map.height, mask);
    result.worst_block = worst.mean;
    result.worst_block_x = worst.x;
    result.worst_block_y = worst.y;
    return result;
}

}  // namespace flip

FlipDifference compare_flip(const Image& reference, const Image& test, float pixels_per_degree, const Mask& mask) {
    flip::check(reference, test, pixels_per_degree);
    return flip::pooled(flip::map_of(flip::linear_of(reference), flip::linear_of(test), pixels_per_degree), mask);
}

}  // namespace tyndall
