#include "report/pixels.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/packing.hpp>
#include <nlohmann/json.hpp>

#include "image/compare.h"

namespace tyndall::report {
namespace {

using nlohmann::json;

float encode_srgb(float x) {
    x = std::clamp(x, 0.0f, 1.0f);
    return x <= 0.0031308f ? 12.92f * x : 1.055f * std::pow(x, 1 / 2.4f) - 0.055f;
}

/// The power of two that brings the largest finite value near the top of what a half holds.
int half_exponent(const Entry& entry) {
    float largest = 0;
    for (const Image* image : {&entry.reference, &entry.test})
        for (const float v : image->floats())
            if (std::isfinite(v)) largest = std::max(largest, std::abs(v));
    return largest > 0 ? 14 - std::ilogb(largest) : 0;
}

std::string encoded(const Image& image, bool half, int exponent) {
    if (!half) return base64(image.pixels);
    std::vector<std::uint16_t> halves;
    halves.reserve(image.value_count());
    for (const float v : image.floats()) halves.push_back(glm::packHalf1x16(std::ldexp(v, exponent)));
    return base64(std::as_bytes(std::span(halves)));
}

/// A map's values as 0..255 of its full scale.
std::string encoded(const Map& map) {
    std::vector<std::uint8_t> bytes;
    bytes.reserve(map.values.value_count());
    for (const float v : map.values.floats()) {
        const float share = std::isfinite(v) ? v / map.full : 1.0f;
        bytes.push_back(static_cast<std::uint8_t>(std::lround(255 * std::clamp(share, 0.0f, 1.0f))));
    }
    return base64(std::as_bytes(std::span(bytes)));
}

}  // namespace

std::string base64(std::span<const std::byte> bytes) {
    constexpr char kDigits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    for (size_t i = 0; i < bytes.size(); i += 3) {
        const size_t left = std::min<size_t>(3, bytes.size() - i);
        unsigned word = 0;
        for (size_t k = 0; k < 3; ++k) word = word << 8 | (k < left ? std::to_integer<unsigned>(bytes[i + k]) : 0u);
        for (size_t k = 0; k < 4; ++k) text += k <= left ? kDigits[word >> (18 - 6 * k) & 63] : '=';
    }
    return text;
}

double exposure_of(const Entry& entry) {
    return entry.exposure > 0 ? entry.exposure : display_exposure(entry.reference);
}

Image relative_error(const Image& reference, const Image& test) {
    const auto r = reference.floats();
    const auto t = test.floats();
    double mean = 0;
    for (const float v : r) mean += static_cast<double>(v) / static_cast<double>(r.size());
    const float floor = std::max(static_cast<float>(0.01 * mean * mean), 1e-30f);
    Image out(reference.width, reference.height, 1, Image::Type::f32);
    for (size_t i = 0; i < out.value_count(); ++i) {
        float sum = 0;
        for (size_t c = 3 * i; c < 3 * i + 3; ++c) sum += (t[c] - r[c]) * (t[c] - r[c]) / (r[c] * r[c] + floor);
        out.floats()[i] = std::isfinite(sum) ? std::sqrt(sum / 3) : 1.0f;
    }
    return out;
}

Image developed(const Image& linear, double exposure) {
    constexpr std::uint8_t kMagenta[3] = {255, 0, 255};
    Image out(linear.width, linear.height, 3, Image::Type::u8);
    const auto in = linear.floats();
    for (size_t i = 0; i + 2 < in.size(); i += 3) {
        const bool finite = std::isfinite(in[i]) && std::isfinite(in[i + 1]) && std::isfinite(in[i + 2]);
        for (size_t c = 0; c < 3; ++c)
            out.bytes()[i + c] = finite ? static_cast<std::uint8_t>(
                                              std::lround(255 * encode_srgb(in[i + c] * static_cast<float>(exposure))))
                                        : kMagenta[c];
    }
    return out;
}

Image thumbnail(const Image& picture, int width) {
    if (picture.width <= width) return picture;
    return resize(picture, width, std::max(1, picture.height * width / picture.width));
}

std::string pixel_script(const Entry& entry, const std::string& id) {
    const Image& r = entry.reference;
    const bool half = static_cast<size_t>(r.width) * static_cast<size_t>(r.height) > kLargestF32;
    const int exponent = half ? half_exponent(entry) : 0;
    json data = {{"width", r.width},
                 {"height", r.height},
                 {"format", half ? "f16" : "f32"},
                 {"scale", std::ldexp(1.0, -exponent)},
                 {"reference", encoded(r, half, exponent)},
                 {"test", encoded(entry.test, half, exponent)},
                 {"maps", json::object()}};
    for (const Map& map : entry.maps) data["maps"][map.name] = encoded(map);
    return "tyndall_pixels(" + json(id).dump() + ", " + data.dump() + ");\n";
}

}  // namespace tyndall::report
