#pragma once
/// Picture files, through OpenImageIO. Loading refuses what is broken; saving gives the same bytes for the same
/// picture.

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "image/image.h"

namespace tyndall {

/// The whole picture of a PNG, JPEG, OpenEXR, Radiance HDR, TIFF, Targa, BMP or WebP file (its first part). The kind is
/// told from the content. Throws Error with the file and the reason when it is no such picture, truncated, corrupt,
/// deep, or larger than kMaxImageSize and kMaxImageBytes allow.
[[nodiscard]] Image load_image(const std::filesystem::path& file);
/// The same from a block of memory, such as an image inside a glTF; `name` is for error messages.
[[nodiscard]] Image load_image(std::span<const std::byte> content, std::string_view name);

struct ImageSize {
    int width = 0;
    int height = 0;
    int channels = 0;
};
/// Reads the header alone. Throws Error as load_image does.
[[nodiscard]] ImageSize load_image_size(const std::filesystem::path& file);

/// Writes an 8- or 16-bit picture of 1 to 4 channels, atomically. Throws Error for another type or when it cannot be
/// written.
void save_png(const std::filesystem::path& file, const Image& image);

struct ExrOptions {
    bool half = false;                                          ///< 16-bit floats, else 32
    std::vector<std::string> channel_names;                     ///< one for each channel; empty: Y, YA, RGB or RGBA
    std::vector<std::pair<std::string, std::string>> metadata;  ///< text attributes
};
/// Writes an f32 picture, ZIP-compressed, atomically. Throws Error for another type or when it cannot be written.
void save_exr(const std::filesystem::path& file, const Image& image, const ExrOptions& options = {});

}  // namespace tyndall
