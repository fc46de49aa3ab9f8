#include "shadows/extinction_clipmap.h"

#include <epoxy/gl.h>
#include <fmt/format.h>

namespace tyndall::participating_media {
void ExtinctionClipmap::update(gpu::ShaderLibrary& shaders, const MediaBuffer& media, const Bounds& bounds,
                               const glm::vec3& camera, const MediaShadowSettings& settings, uint64_t media_version) {
    const auto count = static_cast<size_t>(settings.levels);
    if (texture_.name() == 0 || levels_.size() != count || voxels_ != settings.voxels) {
        levels_.assign(count, {});
        voxels_ = settings.voxels;
        texture_ = gpu::Texture({.shape = gpu::Shape::volume,
                                 .format = gpu::Format::rgba16f,
                                 .width = voxels_,
                                 .height = voxels_,
                                 .layers = voxels_ * settings.levels},
                                "participating_media.clipmap");
    }
    const std::vector<Bounds> boxes = clipmap_boxes(bounds, camera, settings.levels, voxels_);
    filled_ = 0;
    for (size_t i = 0; i < count; ++i) {
        Level& level = levels_[i];
        const bool same = level.media_version == media_version && level.samples == settings.samples &&
                          level.box.low == boxes[i].low && level.box.high == boxes[i].high;
        if (same) continue;
        level = {boxes[i], media_version, settings.samples};
        fill(shaders, media, i, settings.samples);
        ++filled_;
    }
    if (filled_ > 0) glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT);
}

void ExtinctionClipmap::fill(gpu::ShaderLibrary& shaders, const MediaBuffer& media, size_t level, int samples) const {
    static const gpu::ProgramDesc kDesc{.name = "participating_media.shadows.clipmap",
                                        .compute = "participating_media/shadows/clipmap.comp"};
    const gpu::Program& program = shaders.program(kDesc);
    program.use();
    media.bind(program, 1);
    const Bounds& box = levels_[level].box;
    program.image("clipmap", texture_, 0, true);
    program.set("level_low", box.low);
    program.set("level_voxel", box.size() / static_cast<float>(voxels_));
    program.set("first_layer", static_cast<int>(level) * voxels_);
    program.set("voxels", voxels_);
    program.set("samples", samples);
    const auto groups = static_cast<GLuint>((voxels_ + 7) / 8);
    glDispatchCompute(groups, groups, static_cast<GLuint>(voxels_));
}

void ExtinctionClipmap::bind(const gpu::Program& program, const MediaShadowSettings& settings) const {
    program.texture("media_clipmap", texture_, {.filter = gpu::Filter::linear});
    program.set("clipmap_size", glm::ivec3(static_cast<int>(levels_.size()), voxels_, settings.steps));
    for (size_t i = 0; i < levels_.size(); ++i) {
        program.set(fmt::format("clipmap_low[{}]", i), levels_[i].box.low);
        program.set(fmt::format("clipmap_inverse_extent[{}]", i), 1.0f / levels_[i].box.size());
    }
}

void ExtinctionClipmap::forget() {
    levels_.clear();
    texture_ = gpu::Texture();
}

}  // namespace tyndall::participating_media
