#include "render/texture_cache.h"

#include <epoxy/gl.h>

namespace tyndall {
namespace {

/// Grey maps, such as occlusion, take a byte a texel.
bool is_single(const TextureAsset& asset) {
    return asset.image.channels == 1 && asset.image.type == Image::Type::u8 && !asset.srgb_encoded;
}

gpu::Format format_of(const TextureAsset& asset) {
    if (is_single(asset)) return gpu::Format::r8;
    switch (asset.image.type) {
        case Image::Type::u8:
            return asset.srgb_encoded ? gpu::Format::srgb8_alpha8 : gpu::Format::rgba8;
        case Image::Type::u16:
            return gpu::Format::rgba16;
        case Image::Type::f32:
            return gpu::Format::rgba32f;
    }
    return gpu::Format::rgba8;
}

gpu::Wrap wrap_of(TextureWrap wrap) {
    switch (wrap) {
        case TextureWrap::repeat:
            return gpu::Wrap::repeat;
        case TextureWrap::mirror:
            return gpu::Wrap::mirror;
        case TextureWrap::clamp:
            return gpu::Wrap::clamp;
    }
    return gpu::Wrap::repeat;
}

/// Four samples along the longer axis on a GPU; a software renderer pays for each.
float anisotropy() {
    static const float value = gpu::shades_on_processor() ? 1.0f : 4.0f;
    return value;
}

gpu::Texture upload(const TextureAsset& asset) {
    gpu::TextureDesc desc;
    desc.format = format_of(asset);
    desc.width = asset.image.width;
    desc.height = asset.image.height;
    desc.mips = asset.filter == TextureFilter::trilinear ? 0 : 1;
    gpu::Texture texture(desc, asset.name);
    if (asset.image.channels == 4 || is_single(asset)) {
        texture.upload(0, 0, asset.image.pixels.data());
    } else if (asset.image.channels == 3) {
        texture.upload_rgb(0, 0, asset.image.pixels.data());
    } else {
        texture.upload(0, 0, with_channels(asset.image, 4).pixels.data());
    }
    if (desc.mips == 0) texture.generate_mips();
    if (is_single(asset)) {  // grey is red, green and blue
        const GLint grey[] = {GL_RED, GL_RED, GL_RED, GL_ONE};
        glTextureParameteriv(texture.name(), GL_TEXTURE_SWIZZLE_RGBA, grey);
    }
    return texture;
}

}  // namespace

const gpu::Texture& TextureCache::get(const TextureAsset& asset) {
    auto [found, is_new] = entries_.try_emplace(asset.id);
    if (is_new) found->second.texture = upload(asset);
    found->second.last_used = frame_;
    return found->second.texture;
}

gpu::SamplerDesc TextureCache::sampler(const TextureAsset& asset) {
    gpu::SamplerDesc desc;
    desc.wrap_u = wrap_of(asset.wrap_u);
    desc.wrap_v = wrap_of(asset.wrap_v);
    switch (asset.filter) {
        case TextureFilter::nearest:
            desc.filter = gpu::Filter::nearest;
            break;
        case TextureFilter::linear:
            desc.filter = gpu::Filter::linear;
            break;
        case TextureFilter::trilinear:
            desc.filter = gpu::Filter::trilinear;
            desc.anisotropy = anisotropy();
            break;
    }
    return desc;
}

void TextureCache::collect() {
    ++frame_;
    std::erase_if(entries_, [this](const auto& item) { return frame_ - item.second.last_used > kKeptFrames; });
}

}  // namespace tyndall
