#include "skin_maps.h"

#include <algorithm>
#include <functional>

namespace tyndall::skin {
namespace {

/// How much less rough skin is where it is as oily as can be.
constexpr float kOilySmoothing = 0.5f;

/// A map's first channel, 1 everywhere without one.
class Grey {
 public:
    Grey(const std::string& file, AssetStore& assets) {
        if (!file.empty()) image_ = to_float(assets.texture(file, TextureUse::data)->image);
    }
    [[nodiscard]] glm::ivec2 size() const { return {image_.width, image_.height}; }
    [[nodiscard]] bool empty() const { return image_.empty(); }
    void resize_to(glm::ivec2 size) {
        if (!empty() && this->size() != size) image_ = resize(image_, size.x, size.y);
    }
    [[nodiscard]] float at(int x, int y, float otherwise) const { return empty() ? otherwise : image_.at(x, y, 0); }

 private:
    Image image_;
};

/// A texture of what `texel` makes of two maps at a place; the larger one's size.
TextureSlot combined(Grey first, Grey second, const std::string& name,
                     const std::function<glm::vec4(const Grey&, const Grey&, int, int)>& texel) {
    const glm::ivec2 size = glm::max(first.size(), second.size());
    first.resize_to(size);
    second.resize_to(size);
    Image image(size.x, size.y, 4, Image::Type::f32);
    for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x) {
            const glm::vec4 value = texel(first, second, x, y);
            for (int c = 0; c < 4; ++c) image.at(x, y, c) = value[c];
        }
    auto made = std::make_shared<TextureAsset>();
    made->id = new_asset_id();
    made->name = name;
    made->image = to_u8(image);
    return {.texture = std::move(made)};
}

}  // namespace

void set_maps(const SkinMaps& maps, AssetStore& assets, Material& material) {
    if (!maps.colour.empty())
        material.base_colour_texture = {.texture = assets.texture(maps.colour, TextureUse::colour)};
    if (!maps.normal.empty()) material.normal_texture = {.texture = assets.texture(maps.normal, TextureUse::data)};
    if (!maps.roughness.empty() || !maps.oiliness.empty())
        material.metallic_roughness_texture =
            combined(Grey(maps.roughness, assets), Grey(maps.oiliness, assets), "skin roughness",
                     [](const Grey& roughness, const Grey& oil, int x, int y) {
                         const float rough = roughness.at(x, y, 1.0f) * (1.0f - kOilySmoothing * oil.at(x, y, 0.0f));
                         return glm::vec4(1.0f, rough, 0.0f, 1.0f);
                     });
    if (!maps.specular.empty() || !maps.cavity.empty())
        material.specular_texture =
            combined(Grey(maps.specular, assets), Grey(maps.cavity, assets), "skin specular",
                     [](const Grey& specular, const Grey& cavity, int x, int y) {
                         return glm::vec4(glm::vec3(1.0f), specular.at(x, y, 1.0f) * cavity.at(x, y, 1.0f));
                     });
}

}  // namespace tyndall::skin
