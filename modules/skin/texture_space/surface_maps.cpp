#include "texture_space/surface_maps.h"

#include <fmt/format.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <vector>

#include "texture_space/hable_taps.h"

namespace tyndall::skin {
namespace {

/// Taps of Hable's that are nearer to each other, in texels, are one.
constexpr float kMergedTexels = 0.35f;

}  // namespace

Stretch stretch_of(const glm::mat4& transform) {
    Stretch stretch;
    const glm::mat3 linear(transform);
    stretch.scale = std::cbrt(std::abs(glm::determinant(linear)));
    // lengths depend on linear^T linear alone; its root turns nothing
    const glm::mat3 squares = glm::transpose(linear) * linear / (stretch.scale * stretch.scale);
    bool even = true;
    int entry = 0;
    for (int column = 0; column < 3; ++column)
        for (int row = 0; row <= column; ++row) {
            const int thousandths = int(std::lround(1000.0f * squares[column][row]));
            stretch.key[size_t(entry++)] = thousandths;
            even = even && std::abs(thousandths - (row == column ? 1000 : 0)) <= 2;
        }
    if (even)
        stretch.key = {};
    else
        stretch.shape = linear / stretch.scale;
    return stretch;
}

SurfaceMaps::SurfaceMaps(const Mesh& mesh, const MapKey& key, const glm::mat3& shape) {
    std::array<Atlas, LobeBlurs::kLevels> atlases;
    const int levels = key.technique == MapTechnique::lobes ? LobeBlurs::kLevels : 1;
    for (int level = 0; level < levels; ++level) atlases[size_t(level)] = make_atlas(mesh, key.size >> level, shape);
    tile_ = atlases[0].tile;
    texel_m_ = atlases[0].texel_m;
    chunks_ = std::make_unique<AtlasChunks>(atlases[0]);
    if (key.technique == MapTechnique::lobes) {
        blurs_ = std::make_unique<LobeBlurs>(atlases);
        return;
    }
    atlas_ = std::make_unique<GpuAtlas>(atlases[0], true);
    light_ = atlas_->make_map("skin.texture_space.light");
    result_ = atlas_->make_map("skin.texture_space.spread");
    choose(chunks_->all());
}

void SurfaceMaps::choose(const ChunkSet& set) {
    if (blurs_)
        blurs_->choose(set);
    else
        chosen_.update(*atlas_, set, false);
}

void SurfaceMaps::spread(gpu::ShaderLibrary& shaders, const physics::DiffusionProfile& profile) {
    if (blurs_) return blurs_->run(shaders, profile);
    fill_gutters(shaders, light_, *atlas_, Gutters::all);
    const std::vector<HableTap> taps = merged(hable_taps(profile), kMergedTexels * texel_m_);
    // uniforms at places that are known are cheaper where each lane loads its own
    const gpu::Program& program = shaders.program({.name = "skin.texture_space.hable",
                                                   .compute = "skin/texture_space/hable.comp",
                                                   .defines = {"CHUNKS", fmt::format("TAPS {}", taps.size())}});
    program.use();
    program.image("map", light_, 0, false);
    program.image("result", result_, 0, true);
    bind_list(program, "steps", atlas_->steps);
    for (size_t i = 0; i < taps.size(); ++i) {
        program.set(fmt::format("tap_offsets[{}]", i), taps[i].offset);
        program.set(fmt::format("tap_weights[{}]", i), taps[i].weight);
    }
    chosen_.dispatch(program);
    fill_gutters(shaders, result_, *atlas_, Gutters::near);
}

glm::vec4 SurfaceMaps::map_from_uv() const {
    const auto extent = float(atlas().extent);
    const float size = extent - 2.0f * float(kGutterTexels);
    const glm::vec2 offset = (float(kGutterTexels) - size * tile_) / extent;
    return {size / extent, size / extent, offset};
}

}  // namespace tyndall::skin
