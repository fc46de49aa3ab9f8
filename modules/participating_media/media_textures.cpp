#include "media_textures.h"

#include <epoxy/gl.h>
#include <fmt/format.h>

#include <algorithm>
#include <glm/common.hpp>
#include <glm/vector_relational.hpp>

#include "media_buffer.h"
#include "physics/blue_noise.h"

namespace tyndall::participating_media {
namespace {

constexpr int kTableWidth = 2048;  ///< angles: a rainbow's structure is some hundredths of a degree to degrees wide

using Volumes = std::vector<std::shared_ptr<const VolumeAsset>>;

void add_volume(const GridDensity& grid, Volumes& volumes) {
    if (grid.volume && std::ranges::find(volumes, grid.volume) == volumes.end()) volumes.push_back(grid.volume);
}

void add_volumes(const Medium& medium, Volumes& volumes) {
    if (const auto* grid = std::get_if<GridDensity>(&medium.density)) add_volume(*grid, volumes);
    if (const auto* product = std::get_if<ProductDensity>(&medium.density)) {
        if (const auto* grid = std::get_if<GridDensity>(product->base.get())) add_volume(*grid, volumes);
        if (product->mask) add_volume(*product->mask, volumes);
    }
    if (medium.temperature) add_volume(medium.temperature->grid, volumes);
}

/// Half as many voxels along each axis, each the mean of up to eight.
Volume halved(const Volume& fine) {
    Volume coarse;
    coarse.size = (fine.size + 1) / 2;
    coarse.values.reserve(static_cast<size_t>(coarse.size.x) * static_cast<size_t>(coarse.size.y) *
                          static_cast<size_t>(coarse.size.z));
    for (int z = 0; z < coarse.size.z; ++z)
        for (int y = 0; y < coarse.size.y; ++y)
            for (int x = 0; x < coarse.size.x; ++x) {
                float sum = 0.0f;
                for (int k = 0; k < 8; ++k) {
                    const glm::ivec3 at =
                        glm::min(2 * glm::ivec3(x, y, z) + glm::ivec3(k & 1, (k >> 1) & 1, k >> 2), fine.size - 1);
                    sum += fine.at(at.x, at.y, at.z);
                }
                coarse.values.push_back(sum / 8.0f);
            }
    return coarse;
}

glm::ivec3 after_halvings(glm::ivec3 size, int count) {
    for (int i = 0; i < count; ++i) size = (size + 1) / 2;
    return size;
}

/// The atlas' size for grids of these sizes.
glm::ivec3 stacked(const std::vector<glm::ivec3>& rooms) {
    glm::ivec3 size(1, 1, 0);
    for (const glm::ivec3& room : rooms) size = {std::max(size.x, room.x), std::max(size.y, room.y), size.z + room.z};
    size.z = std::max(size.z, 1);
    return size;
}

bool fits(const glm::ivec3& size) {
    int most = 0;
    glGetIntegerv(GL_MAX_3D_TEXTURE_SIZE, &most);
    return std::max({size.x, size.y, size.z}) <= most &&
           int64_t{size.x} * size.y * size.z * int64_t{sizeof(float)} <= kMostGridBytes;
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

std::string MediaTextures::update(const std::vector<const Medium*>& media) {
    Volumes volumes, held;
    std::vector<uint64_t> tables;
    for (const Medium* medium : media) {
        add_volumes(*medium, volumes);
        const PhaseFunction& phase = medium->phase;
        tables.push_back(phase.kind == PhaseKind::tabulated && phase.table ? phase.table->id : 0);
    }
    for (const Slot& slot : slots_) held.push_back(slot.volume);
    std::string reduced;
    if (grids_.name() == 0 || (volumes != held && !replace_grids(volumes))) reduced = place_grids(std::move(volumes));
    if (phase_tables_.name() == 0 || tables != tables_) {
        tables_ = std::move(tables);
        fill_tables(media);
    }
    return reduced;
}

glm::vec4 MediaTextures::place(const VolumeAsset& volume) const {
    for (const Slot& slot : slots_)
        if (slot.volume.get() == &volume) return {glm::vec3(slot.size), static_cast<float>(slot.first_layer)};
    return glm::vec4(0.0f);
}

/// Into the slots that are there, when all fit: what a sequence needs for its next frame.
bool MediaTextures::replace_grids(const Volumes& volumes) {
    if (volumes.size() != slots_.size()) return false;
    for (size_t i = 0; i < volumes.size(); ++i)
        if (glm::any(glm::greaterThan(after_halvings(volumes[i]->volume.size, halvings_), slots_[i].room)))
            return false;
    for (size_t i = 0; i < volumes.size(); ++i) {
        if (slots_[i].volume == volumes[i]) continue;
        slots_[i].volume = volumes[i];
        upload(slots_[i]);
    }
    return true;
}

std::string MediaTextures::place_grids(Volumes volumes) {
    const bool changes =
        !slots_.empty() && slots_.size() == volumes.size();  // a sequence: leave room for larger frames
    std::vector<glm::ivec3> rooms;
    for (halvings_ = 0;; ++halvings_) {
        rooms.clear();
        for (const auto& volume : volumes) {
            const glm::ivec3 size = after_halvings(volume->volume.size, halvings_);
            rooms.push_back(changes ? size + size / 8 : size);
        }
        if (fits(stacked(rooms))) break;
    }
    const glm::ivec3 size = stacked(rooms);
    grids_ = gpu::Texture(
        {.shape = gpu::Shape::volume, .format = gpu::Format::r32f, .width = size.x, .height = size.y, .layers = size.z},
        "participating_media.grids");
    grids_.clear(0, glm::vec4(0.0f));
    slots_.clear();
    int layer = 0;
    for (size_t i = 0; i < volumes.size(); ++i) {
        slots_.push_back({std::move(volumes[i]), rooms[i], {}, layer});
        layer += rooms[i].z;
        upload(slots_.back());
    }
    return halvings_ > 0
               ? fmt::format("detail of grids that are too large for the GPU: 1 voxel of {} along each axis is left",
                             1 << halvings_)
               : "";
}

void MediaTextures::upload(Slot& slot) {
    Volume coarse;
    const Volume* volume = &slot.volume->volume;
    for (int i = 0; i < halvings_; ++i) {
        coarse = halved(*volume);
        volume = &coarse;
    }
    slot.size = volume->size;
    const auto width = static_cast<size_t>(grids_.desc().width);
    std::vector<float> layer(width * static_cast<size_t>(grids_.desc().height));
    for (int z = 0; z < volume->size.z; ++z) {
        for (int y = 0; y < volume->size.y; ++y)
            for (int x = 0; x < volume->size.x; ++x)
                layer[static_cast<size_t>(y) * width + static_cast<size_t>(x)] = volume->at(x, y, z);
        grids_.upload(0, slot.first_layer + z, layer.data());
    }
}

void MediaTextures::fill_tables(const std::vector<const Medium*>& media) {
    const bool any = std::ranges::any_of(tables_, [](uint64_t id) { return id != 0; });
    const int width = any ? kTableWidth : 1;
    phase_tables_ =
        gpu::Texture({.format = gpu::Format::rgba32f, .width = width, .height = static_cast<int>(kMaximumMedia)},
                     "participating_media.phase_tables");
    std::vector<glm::vec4> texels(static_cast<size_t>(width) * kMaximumMedia);
    for (size_t row = 0; any && row < media.size(); ++row) {
        if (tables_[row] == 0) continue;
        const std::vector<glm::vec3>& values = media[row]->phase.table->values;
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
