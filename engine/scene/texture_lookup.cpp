#include "scene/texture_lookup.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>

namespace tyndall {
namespace {

const std::array<float, 256>& srgb_table() {
    static const std::array<float, 256> table = [] {
        std::array<float, 256> values{};
        for (size_t i = 0; i < 256; ++i) {
            const double x = static_cast<double>(i) / 255.0;
            values[i] = static_cast<float>(x <= 0.04045 ? x / 12.92 : std::pow((x + 0.055) / 1.055, 2.4));
        }
        return values;
    }();
    return table;
}

int wrapped(int at, int size, TextureWrap wrap) {
    if (wrap == TextureWrap::clamp) return std::clamp(at, 0, size - 1);
    const int period = wrap == TextureWrap::mirror ? 2 * size : size;
    at %= period;
    if (at < 0) at += period;
    return at < size ? at : 2 * size - 1 - at;
}

glm::vec4 texel(const TextureAsset& texture, int x, int y) {
    const Image& image = texture.image;
    const auto channels = static_cast<size_t>(image.channels);
    const size_t at = (static_cast<size_t>(y) * static_cast<size_t>(image.width) + static_cast<size_t>(x)) * channels;
    glm::vec4 value(0.0f, 0.0f, 0.0f, 1.0f);
    const size_t used = std::min<size_t>(channels, 4);
    if (image.type == Image::Type::f32) {
        const auto* values = reinterpret_cast<const float*>(image.pixels.data()) + at;
        for (size_t c = 0; c < used; ++c) value[static_cast<int>(c)] = values[c];
    } else {
        const auto* values = reinterpret_cast<const uint8_t*>(image.pixels.data()) + at;
        for (size_t c = 0; c < used; ++c)
            value[static_cast<int>(c)] =
                texture.srgb_encoded && c < 3 ? srgb_table()[values[c]] : static_cast<float>(values[c]) / 255.0f;
    }
    return value;
}

}  // namespace

glm::vec4 sample_texture(const TextureAsset& texture, glm::vec2 uv, TextureWrap wrap_u, TextureWrap wrap_v) {
    const Image& image = texture.image;
    if (image.empty()) return glm::vec4(1.0f);
    // Lookups far from the origin would not fit an int; the fraction is what counts there.
    if (!(std::abs(uv.x) < 1e6f && std::abs(uv.y) < 1e6f)) uv = glm::vec2(0.0f);
    const glm::vec2 at = uv * glm::vec2(image.width, image.height);
    const auto fetch = [&](float x, float y) {
        return texel(texture, wrapped(static_cast<int>(x), image.width, wrap_u),
                     wrapped(static_cast<int>(y), image.height, wrap_v));
    };
    if (texture.filter == TextureFilter::nearest) return fetch(std::floor(at.x), std::floor(at.y));
    const glm::vec2 low = glm::floor(at - 0.5f);
    const glm::vec2 f = at - 0.5f - low;
    return glm::mix(glm::mix(fetch(low.x, low.y), fetch(low.x + 1, low.y), f.x),
                    glm::mix(fetch(low.x, low.y + 1), fetch(low.x + 1, low.y + 1), f.x), f.y);
}

}  // namespace tyndall
