#include "texture_space/surface_maps.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <vector>

namespace tyndall::skin {

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
    if (key.technique == MapTechnique::lobes) {
        blurs_ = std::make_unique<LobeBlurs>(atlases);
        return;
    }
    atlas_ = std::make_unique<GpuAtlas>(atlases[0], true);
    light_ = atlas_->make_map("skin.texture_space.light");
    make_steps(atlases[0]);
}

void SurfaceMaps::make_steps(const Atlas& atlas) {
    std::vector<glm::vec4> texels(size_t(atlas.extent()) * size_t(atlas.extent()));
    const auto set = [&](const glm::ivec2& at, const TexelSteps& steps) {
        texels[atlas.index(at)] = {steps.along_u, steps.lean, steps.along_v, 0.0f};
    };
    for (const AtlasTexel& texel : atlas.texels) set(texel.at, texel.steps);
    for (const GutterTexel& gutter : atlas.gutters) set(gutter.at, gutter.steps);
    steps_ = gpu::Texture({.format = gpu::Format::rgba32f, .width = atlas.extent(), .height = atlas.extent()},
                          "skin.texture_space.map_steps");
    steps_.upload(0, 0, texels.data());
}

void SurfaceMaps::spread(gpu::ShaderLibrary& shaders, const physics::DiffusionProfile& profile) {
    if (blurs_)
        blurs_->run(shaders, profile);
    else
        fill_gutters(shaders, light_, *atlas_, false, true);
}

glm::vec4 SurfaceMaps::map_from_uv() const {
    const auto extent = float(atlas().extent);
    const float size = extent - 2.0f * float(kGutterTexels);
    const glm::vec2 offset = (float(kGutterTexels) - size * tile_) / extent;
    return {size / extent, size / extent, offset};
}

}  // namespace tyndall::skin
