#include <epoxy/gl.h>
#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cassert>

#include "core/error.h"
#include "gpu/accounting.h"
#include "gpu/format.h"
#include "gpu/gpu.h"

namespace tyndall::gpu {
namespace {

GLenum target_of(Shape shape) {
    switch (shape) {
        case Shape::flat:
            return GL_TEXTURE_2D;
        case Shape::array:
            return GL_TEXTURE_2D_ARRAY;
        case Shape::volume:
            return GL_TEXTURE_3D;
        case Shape::cube:
            return GL_TEXTURE_CUBE_MAP;
        case Shape::cube_array:
            return GL_TEXTURE_CUBE_MAP_ARRAY;
    }
    return GL_TEXTURE_2D;
}

/// Layers as GL counts them: cube faces one by one, volume slices of that mip.
int depth_of(const TextureDesc& desc, int mip) {
    switch (desc.shape) {
        case Shape::flat:
            return 1;
        case Shape::array:
            return desc.layers;
        case Shape::volume:
            return std::max(1, desc.layers >> mip);
        case Shape::cube:
            return 6;
        case Shape::cube_array:
            return 6 * desc.layers;
    }
    return 1;
}

glm::ivec2 size_of(const TextureDesc& desc, int mip) {
    return {std::max(1, desc.width >> mip), std::max(1, desc.height >> mip)};
}

size_t bytes_of(const TextureDesc& desc) {
    size_t texels = 0;
    for (int mip = 0; mip < desc.mips; ++mip) {
        const glm::ivec2 size = size_of(desc, mip);
        texels += static_cast<size_t>(size.x) * static_cast<size_t>(size.y) * static_cast<size_t>(depth_of(desc, mip));
    }
    return texels * bytes_per_texel(desc.format);
}

int limit(GLenum what) {
    GLint value = 0;
    glGetIntegerv(what, &value);
    return value;
}

/// The description with its mips resolved. Throws Error for sizes that the driver does not have.
TextureDesc checked(TextureDesc desc, std::string_view label) {
    const bool volume = desc.shape == Shape::volume;
    const bool cube = desc.shape == Shape::cube || desc.shape == Shape::cube_array;
    const int largest =
        limit(volume ? GL_MAX_3D_TEXTURE_SIZE : (cube ? GL_MAX_CUBE_MAP_TEXTURE_SIZE : GL_MAX_TEXTURE_SIZE));
    const int layers = volume ? largest : limit(GL_MAX_ARRAY_TEXTURE_LAYERS);
    if (desc.width < 1 || desc.height < 1 || desc.layers < 1 || desc.width > largest || desc.height > largest ||
        depth_of(desc, 0) > std::max(layers, 6) || (cube && desc.width != desc.height))
        throw Error(Diagnostic{
            {},
            fmt::format("texture '{}' cannot be {} x {} x {}", label, desc.width, desc.height, depth_of(desc, 0)),
            fmt::format("1 .. {} texels, 1 .. {} layers, square faces of a cube", largest, layers),
            {}});
    const int extent = std::max({desc.width, desc.height, volume ? desc.layers : 1});
    const int full = static_cast<int>(std::bit_width(static_cast<unsigned int>(extent)));
    desc.mips = desc.mips <= 0 ? full : std::min(desc.mips, full);
    return desc;
}

}  // namespace

Texture::Texture(const TextureDesc& desc, std::string_view label) : desc_(checked(desc, label)) {
    const GLenum target = target_of(desc_.shape);
    const GLenum internal = info(desc_.format).internal;
    glCreateTextures(target, 1, &name_);
    set_label(GL_TEXTURE, name_, label);
    if (desc_.shape == Shape::flat || desc_.shape == Shape::cube)
        glTextureStorage2D(name_, desc_.mips, internal, desc_.width, desc_.height);
    else
        glTextureStorage3D(name_, desc_.mips, internal, desc_.width, desc_.height, depth_of(desc_, 0));
    tally().textures += 1;
    tally().texture_bytes += bytes_of(desc_);
}

Texture::~Texture() {
    if (name_ == 0) return;
    glDeleteTextures(1, &name_);
    tally().textures -= 1;
    tally().texture_bytes -= bytes_of(desc_);
}

void Texture::upload(int mip, int layer, const void* texels) {
    upload_as(mip, layer, info(desc_.format).external, texels);
}

void Texture::upload_rgb(int mip, int layer, const void* texels) {
    assert(info(desc_.format).external == GL_RGBA);
    upload_as(mip, layer, GL_RGB, texels);
}

void Texture::upload_as(int mip, int layer, unsigned int channels, const void* texels) {
    assert(mip < desc_.mips && layer < depth_of(desc_, mip));
    const unsigned int type = info(desc_.format).type;
    const glm::ivec2 size = size_of(desc_, mip);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    if (desc_.shape == Shape::flat)
        glTextureSubImage2D(name_, mip, 0, 0, size.x, size.y, channels, type, texels);
    else
        glTextureSubImage3D(name_, mip, 0, 0, layer, size.x, size.y, 1, channels, type, texels);
}

void Texture::generate_mips() {
    if (desc_.mips > 1) glGenerateTextureMipmap(name_);
}

void Texture::clear(int mip, glm::vec4 value) {
    const auto integer = static_cast<GLuint>(std::max(value.x, 0.0f));
    if (desc_.format == Format::r32ui)
        glClearTexImage(name_, mip, GL_RED_INTEGER, GL_UNSIGNED_INT, &integer);
    else
        glClearTexImage(name_, mip, is_depth(desc_.format) ? GL_DEPTH_COMPONENT : GL_RGBA, GL_FLOAT, &value.x);
}

std::vector<glm::vec4> Texture::read(int mip, int layer) const {
    assert(mip < desc_.mips && layer < depth_of(desc_, mip));
    const glm::ivec2 size = size_of(desc_, mip);
    std::vector<glm::vec4> out(static_cast<size_t>(size.x) * static_cast<size_t>(size.y));
    const auto fetch = [&](GLenum external, GLenum type, void* into, size_t bytes) {
        glMemoryBarrier(GL_TEXTURE_UPDATE_BARRIER_BIT);
        glPixelStorei(GL_PACK_ALIGNMENT, 1);
        glGetTextureSubImage(name_, mip, 0, 0, layer, size.x, size.y, 1, external, type, static_cast<GLsizei>(bytes),
                             into);
    };
    if (desc_.format == Format::r32ui) {
        std::vector<GLuint> integers(out.size());
        fetch(GL_RED_INTEGER, GL_UNSIGNED_INT, integers.data(), integers.size() * sizeof(GLuint));
        for (size_t i = 0; i < out.size(); ++i) out[i] = {static_cast<float>(integers[i]), 0.0f, 0.0f, 1.0f};
    } else if (is_depth(desc_.format)) {
        std::vector<float> depths(out.size());
        fetch(GL_DEPTH_COMPONENT, GL_FLOAT, depths.data(), depths.size() * sizeof(float));
        for (size_t i = 0; i < out.size(); ++i) out[i] = {depths[i], 0.0f, 0.0f, 1.0f};
    } else {
        fetch(GL_RGBA, GL_FLOAT, out.data(), out.size() * sizeof(glm::vec4));
    }
    return out;
}

}  // namespace tyndall::gpu
