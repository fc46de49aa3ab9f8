#include "media_textures.h"

#include <algorithm>

#include "media_buffer.h"
#include "physics/blue_noise.h"

namespace tyndall::participating_media {
namespace {

constexpr int kTableWidth = 2048;  ///< angles: a rainbow's structure is some hundredths of a degree to degrees wide

std::shared_ptr<const VolumeAsset> volume_of(const Medium& medium) {
    const auto* grid = std::get_if<GridDensity>(&medium.density);
    return grid ? grid->volume : nullptr;
}

}  // namespace

gpu::Texture make_blue_noise() {
    const std::vector<float> mask = physics::blue_noise_mask();
    gpu::Texture texture(
        {.format = gpu::Format::r32f, .width = physics::kBlueNoiseSize, .height = physics::kBlueNoiseSize},
        "participating_media.blue_noise");
    texture.upload(0, 0, mask.data());
    return texture;
}

void MediaTextures::update(const std::vector<Medium>& media) {
    std::vector<std::shared_ptr<const VolumeAsset>> volumes;
    std::vector<uint64_t> tables;
    for (const Medium& medium : media) {
        const auto volume = volume_of(medium);
        if (volume && std::ranges::find(volumes, volume) == volumes.end()) volumes.push_back(volume);
        tables.push_back(medium.phase.kind == PhaseKind::tabulated && medium.phase.table ? medium.phase.table->id : 0);
    }
    if (grids_.name() == 0 || volumes != volumes_) {
        volumes_ = std::move(volumes);
        stack_grids();
    }
    if (phase_tables_.name() == 0 || tables != tables_) {
        tables_ = std::move(tables);
        fill_tables(media);
    }
}

int MediaTextures::first_layer(const VolumeAsset& volume) const {
    for (size_t i = 0; i < volumes_.size(); ++i)
        if (volumes_[i].get() == &volume) return layers_[i];
    return 0;
}

void MediaTextures::stack_grids() {
    glm::ivec3 size(1, 1, 0);
    layers_.clear();
    for (const auto& volume : volumes_) {
        layers_.push_back(size.z);
        const glm::ivec3 own = volume->volume.size;
        size = {std::max(size.x, own.x), std::max(size.y, own.y), size.z + own.z};
    }
    size.z = std::max(size.z, 1);
    grids_ = gpu::Texture(
        {.shape = gpu::Shape::volume, .format = gpu::Format::r32f, .width = size.x, .height = size.y, .layers = size.z},
        "participating_media.grids");
    grids_.clear(0, glm::vec4(0.0f));
    std::vector<float> layer(static_cast<size_t>(size.x) * static_cast<size_t>(size.y));
    for (size_t i = 0; i < volumes_.size(); ++i) {
        const Volume& volume = volumes_[i]->volume;
        for (int z = 0; z < volume.size.z; ++z) {
            for (int y = 0; y < volume.size.y; ++y)
                for (int x = 0; x < volume.size.x; ++x)
                    layer[static_cast<size_t>(y) * static_cast<size_t>(size.x) + static_cast<size_t>(x)] =
                        volume.at(x, y, z);
            grids_.upload(0, layers_[i] + z, layer.data());
        }
    }
}

void MediaTextures::fill_tables(const std::vector<Medium>& media) {
    const bool any = std::ranges::any_of(tables_, [](uint64_t id) { return id != 0; });
    const int width = any ? kTableWidth : 1;
    phase_tables_ =
        gpu::Texture({.format = gpu::Format::rgba32f, .width = width, .height = static_cast<int>(kMaximumMedia)},
                     "participating_media.phase_tables");
    std::vector<glm::vec4> texels(static_cast<size_t>(width) * kMaximumMedia);
    for (size_t row = 0; any && row < media.size(); ++row) {
        if (tables_[row] == 0) continue;
        const std::vector<glm::vec3>& values = media[row].phase.table->values;
        for (int x = 0; x < width; ++x) {
            const float at =
                static_cast<float>(x) / static_cast<float>(width - 1) * static_cast<float>(values.size() - 1);
            const size_t low = std::min(static_cast<size_t>(at), values.size() - 2);
            texels[row * static_cast<size_t>(width) + static_cast<size_t>(x)] =
                glm::vec4(glm::mix(values[low], values[low + 1], at - static_cast<float>(low)), 0.0f);
        }
    }
    phase_tables_.upload(0, 0, texels.data());
}

}  // namespace tyndall::participating_media
