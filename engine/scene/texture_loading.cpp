#include "scene/texture_loading.h"

#include <cmath>
#include <utility>

#include "core/log.h"
#include "image/image_io.h"

namespace tyndall {
namespace {

/// The largest half float: what renderers write for "too bright".
constexpr float kBrightest = 65504.0f;

/// Solvers average over probes and mips: one pixel of NaN or infinity would blacken or blind the whole scene.
void make_finite(Image& image, std::string_view name) {
    size_t mended = 0;
    for (float& value : image.floats())
        if (!std::isfinite(value)) {
            value = value > 0.0f ? kBrightest : 0.0f;
            ++mended;
        }
    if (mended > 0) log::warning("{}: {} values are not finite and were cut off", name, mended);
}

}  // namespace

void fill_texture(TextureAsset& texture, Image image, TextureUse use, const ColorConfig& config,
                  std::string_view space) {
    if (image.channels > 4) image = with_channels(image, 4);
    texture.srgb_encoded = false;
    if (use == TextureUse::probe) {
        texture.image = with_channels(config.to_working(image, space), 3);
    } else if (use == TextureUse::data || config.is_data(space)) {
        texture.image = image.type == Image::Type::u16 ? to_float(image) : std::move(image);
    } else if (image.type == Image::Type::u8 && config.decodes_as_srgb(space)) {
        texture.image = std::move(image);
        texture.srgb_encoded = true;
    } else {
        texture.image = config.to_working(image, space);
    }
    if (texture.image.type == Image::Type::f32) make_finite(texture.image, texture.name);
}

TextureAsset load_texture(const std::filesystem::path& file, std::string_view name, TextureUse use,
                          const ColorConfig& config) {
    TextureAsset texture{.id = new_asset_id(), .name = std::string(name)};
    fill_texture(texture, load_image(file), use, config,
                 use == TextureUse::data ? std::string("data") : config.space_of_file(file));
    return texture;
}

}  // namespace tyndall
