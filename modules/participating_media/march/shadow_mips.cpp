#include "march/shadow_mips.h"

#include <epoxy/gl.h>

#include <algorithm>

#include "render/shadow_maps.h"

namespace tyndall::participating_media {
namespace {

constexpr int kFirst = 8;  ///< texels of a page along a texel of the first level, as in shadow_mips.comp

GLuint groups(int texels) {
    return static_cast<GLuint>((texels + 7) / 8);
}

}  // namespace

bool ShadowMips::update(const Frame& frame) {
    const gpu::Texture* pages = frame.shadow_maps.texture();
    if (pages == nullptr || pages->desc().width < kFirst) return false;
    std::vector<uint64_t> versions;
    for (size_t view = 0; view < frame.shadow_maps.plan().views.size(); ++view)
        versions.push_back(frame.shadow_maps.version(view));
    const gpu::TextureDesc wanted{.shape = gpu::Shape::array,
                                  .format = gpu::Format::rg32f,
                                  .width = pages->desc().width / kFirst,
                                  .height = pages->desc().height / kFirst,
                                  .layers = pages->desc().layers,
                                  .mips = 0};
    const bool fits = mips_.name() != 0 && mips_.desc().width == wanted.width && mips_.desc().layers == wanted.layers;
    if (fits && versions == versions_) return true;
    if (!fits) mips_ = gpu::Texture(wanted, "participating_media.shadow_mips");
    versions_ = std::move(versions);
    const gpu::Program& first = frame.shaders.program({.name = "participating_media.shadow_mips_first",
                                                       .compute = "participating_media/march/shadow_mips.comp",
                                                       .defines = {"FIRST_LEVEL"}});
    const gpu::Program& next = frame.shaders.program(
        {.name = "participating_media.shadow_mips", .compute = "participating_media/march/shadow_mips.comp"});
    for (int level = 0; level < mips_.desc().mips; ++level) {
        const gpu::Program& program = level == 0 ? first : next;
        program.use();
        program.texture("shadow_depths", *pages, {.filter = gpu::Filter::nearest});
        if (level > 0) program.image("finer", mips_, level - 1, false);
        program.image("coarser", mips_, level, true);
        const GLuint across = groups(std::max(wanted.width >> level, 1));
        glDispatchCompute(across, across, static_cast<GLuint>(wanted.layers));
        glMemoryBarrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT | GL_TEXTURE_FETCH_BARRIER_BIT);
    }
    return true;
}

void ShadowMips::bind(const gpu::Program& program) const {
    program.texture("shadow_mips", mips_, {.filter = gpu::Filter::nearest});
    program.set("shadow_mip_levels", mips_.desc().mips);
}

}  // namespace tyndall::participating_media
