#include "image/image.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "core/error.h"

namespace tyndall {
namespace {

template <class T>
std::span<T> view_as(auto& pixels, bool right_type) {
    if (!right_type) throw Error("the picture's values are of another type: convert it first");
    return {reinterpret_cast<T*>(pixels.data()), pixels.size() / sizeof(T)};
}

/// How much of each source texel one target texel covers along one axis; the weights sum to 1.
struct Coverage {
    int first = 0;
    std::vector<float> weights;
};

std::vector<Coverage> coverage(int source, int target) {
    std::vector<Coverage> all(static_cast<size_t>(target));
    const double step = static_cast<double>(source) / target;
    for (int i = 0; i < target; ++i) {
        const double low = i * step;
        const double high = i + 1 == target ? source : (i + 1) * step;
        Coverage& one = all[static_cast<size_t>(i)];
        one.first = std::min(static_cast<int>(low), source - 1);
        for (int j = one.first; j == one.first || (j < source && j < high); ++j)
            one.weights.push_back(static_cast<float>((std::min(high, j + 1.0) - std::max(low, 1.0 * j)) / step));
    }
    return all;
}

/// Shrinks along rows: `lines` lines of `source` texels, each texel `stride` values wide.
std::vector<float> shrink(std::span<const float> in, size_t lines, int source, int target, size_t stride) {
    const std::vector<Coverage> covers = coverage(source, target);
    std::vector<float> out(lines * covers.size() * stride);
    for (size_t line = 0; line < lines; ++line)
        for (size_t i = 0; i < covers.size(); ++i) {
            float* to = &out[(line * covers.size() + i) * stride];
            const float* from =
                &in[(line * static_cast<size_t>(source) + static_cast<size_t>(covers[i].first)) * stride];
            for (const float weight : covers[i].weights) {
                for (size_t k = 0; k < stride; ++k) to[k] += weight * from[k];
                from += stride;
            }
        }
    return out;
}

template <class T>
void quantise(std::span<const float> in, std::span<T> out) {
    constexpr float kMax = std::is_same_v<T, std::uint8_t> ? 255.0f : 65535.0f;
    for (size_t i = 0; i < in.size(); ++i)  // the comparison sends NaN to 0
        out[i] = in[i] > 0.0f ? static_cast<T>(std::lround(std::min(in[i], 1.0f) * kMax)) : T{0};
}

Image to_type(const Image& image, Image::Type type) {
    if (type == Image::Type::f32) return to_float(image);
    Image out(image.width, image.height, image.channels, type);
    const Image values = to_float(image);
    if (type == Image::Type::u8)
        quantise(values.floats(), out.bytes());
    else
        quantise(values.floats(), out.shorts());
    return out;
}

}  // namespace

Image::Image(int w, int h, int c, Type t) : width(w), height(h), channels(c), type(t) {
    check_image_size(w, h, c, t);
    pixels.resize(value_count() * bytes_per_value(t));
}

size_t Image::value_count() const {
    return static_cast<size_t>(width) * static_cast<size_t>(height) * static_cast<size_t>(channels);
}

std::span<const float> Image::floats() const {
    return view_as<const float>(pixels, type == Type::f32);
}
std::span<float> Image::floats() {
    return view_as<float>(pixels, type == Type::f32);
}
std::span<const std::uint8_t> Image::bytes() const {
    return view_as<const std::uint8_t>(pixels, type == Type::u8);
}
std::span<std::uint8_t> Image::bytes() {
    return view_as<std::uint8_t>(pixels, type == Type::u8);
}
std::span<const std::uint16_t> Image::shorts() const {
    return view_as<const std::uint16_t>(pixels, type == Type::u16);
}
std::span<std::uint16_t> Image::shorts() {
    return view_as<std::uint16_t>(pixels, type == Type::u16);
}

size_t bytes_per_value(Image::Type type) {
    return type == Image::Type::u8 ? 1 : type == Image::Type::u16 ? 2 : 4;
}

void check_image_size(int width, int height, int channels, Image::Type type) {
    if (width < 1 || height < 1 || channels < 1 || width > kMaxImageSize || height > kMaxImageSize || channels > 64)
        throw Error(Diagnostic{{},
                               fmt::format("a picture of {}x{} pixels with {} channels", width, height, channels),
                               fmt::format("1 to {} pixels a side, 1 to 64 channels", kMaxImageSize),
                               {}});
    const size_t size = static_cast<size_t>(width) * static_cast<size_t>(height) * static_cast<size_t>(channels) *
                        bytes_per_value(type);
    if (size > kMaxImageBytes)
        throw Error(Diagnostic{{},
                               fmt::format("a picture of {} MiB", size >> 20),
                               fmt::format("at most {} MiB of pixels", kMaxImageBytes >> 20),
                               {}});
}

Image to_float(const Image& image) {
    if (image.type == Image::Type::f32) return image;
    Image out(image.width, image.height, image.channels, Image::Type::f32);
    if (image.type == Image::Type::u8)
        std::ranges::transform(image.bytes(), out.floats().begin(), [](auto v) { return static_cast<float>(v) / 255; });
    else
        std::ranges::transform(image.shorts(), out.floats().begin(),
                               [](auto v) { return static_cast<float>(v) / 65535; });
    return out;
}

Image to_u8(const Image& image) {
    return image.type == Image::Type::u8 ? image : to_type(image, Image::Type::u8);
}

Image with_channels(const Image& image, int channels) {
    if (image.channels == channels) return image;
    Image out(image.width, image.height, channels, image.type);
    const size_t size = bytes_per_value(image.type);
    const bool grey = image.channels <= 2;
    const float one_float = 1.0f;
    std::byte one[4] = {std::byte{255}, std::byte{255}};  // of either integer type
    if (image.type == Image::Type::f32) std::memcpy(one, &one_float, sizeof one);

    const bool has_alpha = image.channels == 2 || image.channels >= 4;
    const auto source_of = [&](int channel) {  // -1: opaque alpha
        if (channel == (channels == 2 ? 1 : 3)) return has_alpha ? (grey ? 1 : 3) : -1;
        if (grey) return 0;
        return channel < image.channels ? channel : -1;
    };
    const size_t count = static_cast<size_t>(image.width) * static_cast<size_t>(image.height);
    for (int channel = 0; channel < channels; ++channel) {
        const int source = source_of(channel);
        std::byte* to = &out.pixels[static_cast<size_t>(channel) * size];
        const std::byte* from = source < 0 ? one : &image.pixels[static_cast<size_t>(source) * size];
        const size_t from_step = source < 0 ? 0 : static_cast<size_t>(image.channels) * size;
        for (size_t i = 0; i < count; ++i, to += static_cast<size_t>(channels) * size, from += from_step)
            std::memcpy(to, from, size);
    }
    return out;
}

Image cropped(const Image& image, int x, int y, int width, int height) {
    if (x < 0 || y < 0 || width <= 0 || height <= 0 || width > image.width - x || height > image.height - y)
        throw Error(Diagnostic{
            {},
            fmt::format("a rectangle of {}x{} pixels at x {}, y {} does not lie in the picture", width, height, x, y),
            fmt::format("one within its {}x{} pixels", image.width, image.height)});
    Image out(width, height, image.channels, image.type);
    const size_t pixel = static_cast<size_t>(image.channels) * bytes_per_value(image.type);
    const size_t row = pixel * static_cast<size_t>(width);
    for (int line = 0; line < height; ++line) {
        const auto from = static_cast<size_t>(y + line) * static_cast<size_t>(image.width) + static_cast<size_t>(x);
        std::memcpy(&out.pixels[row * static_cast<size_t>(line)], &image.pixels[pixel * from], row);
    }
    return out;
}

Image flip_rows(const Image& image) {
    Image out = image;
    const size_t row = image.pixels.size() / static_cast<size_t>(std::max(image.height, 1));
    for (size_t y = 0; y < static_cast<size_t>(image.height); ++y)
        std::memcpy(&out.pixels[y * row], &image.pixels[(static_cast<size_t>(image.height) - 1 - y) * row], row);
    return out;
}

Image resize(const Image& image, int width, int height) {
    Image out(width, height, image.channels, Image::Type::f32);
    const Image source = to_float(image);
    const auto channels = static_cast<size_t>(image.channels);
    const std::vector<float> narrow =
        shrink(source.floats(), static_cast<size_t>(image.height), image.width, width, channels);
    const std::vector<float> low = shrink(narrow, 1, image.height, height, static_cast<size_t>(width) * channels);
    std::ranges::copy(low, out.floats().begin());
    return to_type(out, image.type);
}

Image box_downsample(const Image& image, int factor) {
    if (factor < 1 || image.width % factor != 0 || image.height % factor != 0)
        throw Error(
            fmt::format("a picture of {}x{} pixels cannot be divided by {}", image.width, image.height, factor));
    return resize(image, image.width / factor, image.height / factor);
}

}  // namespace tyndall
