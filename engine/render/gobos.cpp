#include "render/gobos.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <bit>

#include "render/gpu_scene.h"

namespace tyndall {
namespace {

constexpr int kLargest = 1024;
constexpr size_t kMaxBytes = 64u << 20;
constexpr gpu::Format kFormat = gpu::Format::rgba32f;

/// Largest side among the images, a power of two within the limits.
int common_size(const std::vector<const TextureAsset*>& images) {
    int largest = 1;
    for (const TextureAsset* image : images) largest = std::max({largest, image->image.width, image->image.height});
    int size = static_cast<int>(std::bit_ceil(static_cast<unsigned>(std::min(largest, kLargest))));
    const auto bytes = [&] {
        return static_cast<size_t>(size) * static_cast<size_t>(size) * images.size() * gpu::bytes_per_texel(kFormat);
    };
    while (size > 64 && bytes() > kMaxBytes) size /= 2;
    return size;
}

}  // namespace

void Gobos::update(const RenderScene& scene, GpuScene& gpu_scene, gpu::ShaderLibrary& shaders) {
    wanted_.clear();
    for (const Light& light : scene.lights) {
        const TextureAsset* image = light.gobo.get();
        const bool known =
            image == nullptr || std::ranges::find(wanted_, image->id, &TextureAsset::id) != wanted_.end();
        if (!known) wanted_.push_back(image);
    }
    const bool same = texture_.name() != 0 && std::ranges::equal(wanted_, images_, {}, &TextureAsset::id);
    if (same) return;
    images_.clear();
    const int size = common_size(wanted_);
    texture_ = gpu::Texture({.shape = gpu::Shape::array,
                             .format = kFormat,
                             .width = size,
                             .height = size,
                             .layers = std::max(1, static_cast<int>(wanted_.size())),
                             .mips = 0},
                            "light_gobos");
    for (size_t i = 0; i < wanted_.size(); ++i) copy(*wanted_[i], static_cast<int>(i), gpu_scene, shaders);
    texture_.generate_mips();
    for (const TextureAsset* image : wanted_) images_.push_back(image->id);
}

void Gobos::copy(const TextureAsset& image, int layer, GpuScene& gpu_scene, gpu::ShaderLibrary& shaders) {
    const gpu::Framebuffer::Attachment target{&texture_, 0, layer};
    const gpu::Framebuffer framebuffer(std::span(&target, 1), {}, "light_gobos");
    framebuffer.bind();
    const gpu::Program& program = shaders.program({.name = "gobo_copy", .fragment = "render/shaders/gobo_copy.frag"});
    program.use();
    program.texture("image", gpu_scene.texture(image), {.filter = gpu::Filter::trilinear});
    glDisable(GL_BLEND);
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_SCISSOR_TEST);
    gpu::draw_fullscreen();
}

int Gobos::layer_of(const TextureAsset* image) const {
    const auto found = image == nullptr ? images_.end() : std::ranges::find(images_, image->id);
    return found == images_.end() ? -1 : static_cast<int>(found - images_.begin());
}

void Gobos::bind(const gpu::Program& program) const {
    program.texture("light_gobos", texture_, {.filter = gpu::Filter::trilinear});
}

}  // namespace tyndall
