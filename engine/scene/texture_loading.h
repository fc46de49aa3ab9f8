#pragma once
/// From a decoded picture to a texture of the right type and colour space.

#include <string>
#include <string_view>

#include "color/color.h"
#include "scene/asset_store.h"

namespace tyndall {

/// Fills a texture's `image` and `srgb_encoded` for its use; `space` is the picture's colour space (not looked at for
/// data). Colours keep their bytes where the GPU decodes them, since that is a quarter of the memory of floats; all
/// other colours are converted to the working space. Data keeps its numbers. Probes are f32 of three channels; what is
/// not finite in them is cut off. Thread-safe.
void fill_texture(TextureAsset& texture, Image image, TextureUse use, const ColorConfig& config,
                  std::string_view space);

/// Reads a picture file; the configuration's file rules tell its colour space. Throws Error naming the file.
[[nodiscard]] TextureAsset load_texture(const std::filesystem::path& file, std::string_view name, TextureUse use,
                                        const ColorConfig& config);

}  // namespace tyndall
