#pragma once
// Textures of glTF files; included by the glTF sources alone.

#include <map>
#include <memory>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "scene/asset_store.h"
#include "scene/gltf_file.h"

namespace tyndall {

/// The textures of a file. An image that is used as colours and as data, or with several samplers, is one asset for
/// each.
class GltfTextures {
 public:
    GltfTextures(GltfFile& file, const ColorConfig& config, std::string name)
        : file_(file), config_(config), name_(std::move(name)) {}

    /// The asset of a texture, without its picture until load(); null, with a warning, when it has no image. Throws
    /// Error.
    [[nodiscard]] std::shared_ptr<const TextureAsset> get(int texture, TextureUse use, std::string_view pointer);
    /// Decodes every image that was asked for, once, on all cores. Throws Error.
    void load();

 private:
    using Key = std::tuple<TextureUse, TextureFilter, TextureWrap, TextureWrap>;
    struct Source {
        std::filesystem::path file;  ///< empty when the bytes are inside the glTF
        std::map<Key, std::shared_ptr<TextureAsset>> assets;
    };

    [[nodiscard]] Key key_of(int sampler, TextureUse use, std::string_view pointer) const;
    [[nodiscard]] Image decode(int image, const Source& source) const;

    GltfFile& file_;
    const ColorConfig& config_;
    std::string name_;
    std::map<int, Source> images_;  ///< by index of the image
};

}  // namespace tyndall
