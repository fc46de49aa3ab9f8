#include "scene/gltf_textures.h"

#include <iterator>

#include "color/color.h"
#include "core/error.h"
#include "core/parallel.h"
#include "image/image_io.h"
#include "scene/texture_loading.h"

namespace tyndall {
namespace {

TextureFilter filter_of(const tinygltf::Sampler& sampler) {
    if (sampler.magFilter == TINYGLTF_TEXTURE_FILTER_NEAREST) return TextureFilter::nearest;
    const bool no_mips =
        sampler.minFilter == TINYGLTF_TEXTURE_FILTER_NEAREST || sampler.minFilter == TINYGLTF_TEXTURE_FILTER_LINEAR;
    return no_mips ? TextureFilter::linear : TextureFilter::trilinear;
}

std::string pointer_of(int image) {
    return "/images/" + std::to_string(image);
}

}  // namespace

GltfTextures::Key GltfTextures::key_of(int index, TextureUse use, std::string_view pointer) const {
    const tinygltf::Sampler usual;
    const tinygltf::Sampler& sampler = index < 0 ? usual : file_.at(file_.model.samplers, index, "sampler", pointer);
    const auto wrap_of = [&](int wrap) {
        switch (wrap) {
            case TINYGLTF_TEXTURE_WRAP_REPEAT:
                return TextureWrap::repeat;
            case TINYGLTF_TEXTURE_WRAP_MIRRORED_REPEAT:
                return TextureWrap::mirror;
            case TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE:
                return TextureWrap::clamp;
            default:
                file_.fail("/samplers/" + std::to_string(index), "unknown wrapping mode " + std::to_string(wrap),
                           "10497, 33071 or 33648");
        }
    };
    return {use, filter_of(sampler), wrap_of(sampler.wrapS), wrap_of(sampler.wrapT)};
}

std::shared_ptr<const TextureAsset> GltfTextures::get(int index, TextureUse use, std::string_view pointer) {
    const tinygltf::Texture& texture = file_.at(file_.model.textures, index, "texture", pointer);
    const std::string here = "/textures/" + std::to_string(index);
    if (texture.source < 0) {
        file_.warn("textures without an image of a supported kind are ignored");
        return nullptr;
    }
    const tinygltf::Image& image = file_.at(file_.model.images, texture.source, "image", here);
    const Key key = key_of(texture.sampler, use, here);
    const auto [source, is_new] = images_.try_emplace(texture.source);
    if (is_new && image.bufferView < 0 && !image.uri.empty())
        source->second.file = file_.resolve_uri(image.uri, pointer_of(texture.source));
    std::shared_ptr<TextureAsset>& asset = source->second.assets[key];
    if (!asset) {
        asset = std::make_shared<TextureAsset>();
        asset->id = new_asset_id();
        asset->name = name_ + ": " + (image.name.empty() ? pointer_of(texture.source) : image.name);
        asset->filter = std::get<1>(key);
        asset->wrap_u = std::get<2>(key);
        asset->wrap_v = std::get<3>(key);
    }
    return asset;
}

Image GltfTextures::decode(int index, const Source& source) const {
    if (!source.file.empty()) return load_image(source.file);
    const tinygltf::Image& image = file_.model.images[static_cast<size_t>(index)];
    const std::string pointer = pointer_of(index);
    const auto bytes =
        image.bufferView >= 0 ? file_.bytes_of_view(image.bufferView, pointer) : std::as_bytes(std::span(image.image));
    const std::string label = image.name.empty() ? pointer : pointer + " (" + image.name + ")";
    return load_image(bytes, file_.path.string() + ": " + label);
}

void GltfTextures::load() {
    std::vector<std::pair<int, Source*>> jobs;
    for (auto& [image, source] : images_) jobs.emplace_back(image, &source);
    const std::string srgb = jobs.empty() ? std::string() : config_.srgb_texture_space();
    parallel_for(0, jobs.size(), 1, [&](size_t first, size_t last) {
        for (size_t i = first; i < last; ++i) {
            auto& [index, source] = jobs[i];
            Image image = decode(index, *source);
            const auto last_use = std::prev(source->assets.end());
            for (auto use = source->assets.begin(); use != last_use; ++use)
                fill_texture(*use->second, image, std::get<0>(use->first), config_, srgb);
            fill_texture(*last_use->second, std::move(image), std::get<0>(last_use->first), config_, srgb);
        }
    });
}

}  // namespace tyndall
