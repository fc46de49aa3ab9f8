#pragma once
/// A picture in memory and the few operations that loading, comparing and saving need.

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace tyndall {

/// Pixels, tightly packed, channels interleaved, top row first. The numbers are what the file holds: an Image knows
/// nothing of colour spaces (color/color.h does), and alpha is not multiplied into the colours.
struct Image {
    enum class Type : std::uint8_t {
        u8,   ///< 0..255 stands for 0..1
        u16,  ///< 0..65535 stands for 0..1
        f32   ///< as it is; half floats and wider types are loaded as this
    };

    int width = 0;
    int height = 0;
    int channels = 0;
    Type type = Type::f32;
    std::vector<std::byte> pixels;

    Image() = default;
    /// A picture of zeros. Throws Error when a size is not positive or above kMaxImageSize.
    Image(int width, int height, int channels, Type type);

    [[nodiscard]] bool empty() const { return pixels.empty(); }
    /// The number of values: width x height x channels.
    [[nodiscard]] size_t value_count() const;
    /// All values, channels interleaved. Throws Error when the type is another.
    [[nodiscard]] std::span<const float> floats() const;
    [[nodiscard]] std::span<float> floats();
    [[nodiscard]] std::span<const std::uint8_t> bytes() const;
    [[nodiscard]] std::span<std::uint8_t> bytes();
    [[nodiscard]] std::span<const std::uint16_t> shorts() const;
    [[nodiscard]] std::span<std::uint16_t> shorts();
    /// One value of an f32 picture; no bounds check. Row 0 is the top.
    [[nodiscard]] float at(int x, int y, int channel) const { return floats()[index(x, y, channel)]; }
    [[nodiscard]] float& at(int x, int y, int channel) { return floats()[index(x, y, channel)]; }

 private:
    [[nodiscard]] size_t index(int x, int y, int channel) const {
        const auto row = static_cast<size_t>(y) * static_cast<size_t>(width);
        return (row + static_cast<size_t>(x)) * static_cast<size_t>(channels) + static_cast<size_t>(channel);
    }
};

/// The largest width or height of a picture, and the most bytes its pixels may take.
inline constexpr int kMaxImageSize = 16384;
inline constexpr size_t kMaxImageBytes = size_t{1} << 30;

[[nodiscard]] size_t bytes_per_value(Image::Type type);
/// Throws Error when such a picture is beyond the limits above or has a size that is not positive.
void check_image_size(int width, int height, int channels, Image::Type type);

/// The same numbers as f32, 0..1 for the integer types.
[[nodiscard]] Image to_float(const Image& image);
/// Rounded to 8 bits; values outside 0..1 are clamped, NaN becomes 0.
[[nodiscard]] Image to_u8(const Image& image);
/// As many channels as asked: grey is copied to red, green and blue; a missing alpha is 1; channels past `channels`
/// are dropped. Two channels are grey and alpha.
[[nodiscard]] Image with_channels(const Image& image, int channels);
/// Turned upside down: OpenGL's bottom row first from our top row first, and back.
[[nodiscard]] Image flip_rows(const Image& image);
/// The rectangle whose left top pixel is (x, y). Throws Error when it is empty or reaches over the picture's border.
[[nodiscard]] Image cropped(const Image& image, int x, int y, int width, int height);
/// Each new pixel is the exact area average of what it covers (box filter); enlarging repeats pixels.
[[nodiscard]] Image resize(const Image& image, int width, int height);
/// resize by a whole factor. Throws Error when it does not divide the picture's sides.
[[nodiscard]] Image box_downsample(const Image& image, int factor);

}  // namespace tyndall
