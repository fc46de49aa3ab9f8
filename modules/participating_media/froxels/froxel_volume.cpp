#include "froxels/froxel_volume.h"

#include <cmath>

namespace tyndall::participating_media {
namespace {

/// 32 bits: sunlight beside a lamp passes the range of half floats, and the mean over frames must not round.
constexpr gpu::Format kFormat = gpu::Format::rgba32f;

/// As shaders/froxels/grid.glsl's froxel_place lays it out.
gpu::Texture volume(const glm::ivec3& size, std::string_view label) {
    return {{.shape = gpu::Shape::volume, .format = kFormat, .width = size.z, .height = size.x, .layers = size.y},
            label};
}

}  // namespace

bool FroxelVolume::make(bool history) {
    const gpu::TextureDesc& has = source[0].desc();
    const bool fits = source[0].name() != 0 && glm::ivec3(has.height, has.layers, has.width) == grid.size;
    if (fits && (source[1].name() != 0) == history) return false;
    const gpu::TextureDesc flat{.format = kFormat, .width = grid.size.x, .height = grid.size.y};
    gpu::TextureDesc single = flat;
    single.format = gpu::Format::rg32f;
    columns = gpu::Texture(flat, "participating_media.froxel_columns");
    reach = gpu::Texture(single, "participating_media.froxel_reach");
    source[0] = volume(grid.size, "participating_media.froxel_source");
    source[1] = history ? volume(grid.size, "participating_media.froxel_source") : gpu::Texture();
    radiance = volume(grid.size + glm::ivec3(0, 0, 1), "participating_media.froxel_radiance");
    radiance.clear(0, glm::vec4(0.0f));  // what nobody looks at is never written
    now = 0;
    return true;
}

int FroxelVolume::slices_a_thread() const {
    constexpr int kFew = 8;  // a graphics card wants many threads; a processor takes long to begin one
    return gpu::shades_on_processor() ? grid.size.z : kFew;
}

void FroxelVolume::bind_grid(const gpu::Program& program) const {
    program.set("froxel_size", grid.size);
    program.set("slices_a_thread", slices_a_thread());
    program.set("froxel_depths", grid.depths());
    program.set("froxel_step", std::exp(grid.growth / static_cast<float>(grid.size.z)) - 1.0f);
}

void FroxelVolume::bind(const gpu::Program& program) {
    if (radiance.name() == 0) {  // programs want something bound
        radiance = volume(glm::ivec3(1), "participating_media.froxel_radiance");
        columns = gpu::Texture({.format = kFormat}, "participating_media.froxel_columns");
    }
    bind_grid(program);
    program.set("froxels_active", active ? 1 : 0);
    program.texture("froxel_radiance", radiance, {.filter = gpu::Filter::nearest});
    program.texture("froxel_columns", columns, {.filter = gpu::Filter::nearest});
}

}  // namespace tyndall::participating_media
