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

/// The names of a picture file's layers, in the file's order: what stands before the last dot of the channels' names,
/// and "" for channels without a dot, such as R, G, B. Throws Error as load_image does.
[[nodiscard]] std::vector<std::string> load_layer_names(const std::filesystem::path& file);
/// One layer of a picture file as f32, its other layers unread: at most four channels, in the order R G B A, X Y Z or
/// Y. The layer "" of a file that has no plain channels, but one layer alone, is that. Throws Error as load_image does,
/// and for a layer that is not there (with the nearest name) or has more channels.
[[nodiscard]] Image load_layer(const std::filesystem::path& file, std::string_view layer);

/// A picture file's text attribute, or an empty text. Throws Error as load_image does.
[[nodiscard]] std::string load_text_attribute(const std::filesystem::path& file, const std::string& name);

/// Writes an 8- or 16-bit picture of 1 to 4 channels, atomically. Throws Error for another type or when it cannot be
/// written.
void save_png(const std::filesystem::path& file, const Image& image);

struct ExrOptions {
    bool half = false;                                          ///< 16-bit floats, else 32
    std::vector<std::string> channel_names;                     ///< one for each channel; empty: Y, YA, RGB or RGBA
    std::vector<std::pair<std::string, std::string>> metadata;  ///< text attributes
    std::vector<std::string> full_channels;                     ///< keep 32 bits where the others are half
};
/// Writes an f32 picture, ZIP-compressed, atomically. Throws Error for another type or when it cannot be written.
void save_exr(const std::filesystem::path& file, const Image& image, const ExrOptions& options = {});

}  // namespace tyndall
