#include "media_buffer.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/matrix.hpp>

#include "core/log.h"
#include "render/frame.h"

namespace tyndall::participating_media {
namespace {

/// As in shaders/media.glsl.
struct GpuMedium {
    glm::mat4 box_from_world{1.0f};
    glm::vec4 sigma_s_phase{0.0f};
    glm::vec4 sigma_t{0.0f};
    glm::vec4 phase_parameters{0.0f};
    glm::vec4 emission_even{0.0f};
    glm::vec4 blobs_height{0.0f};
    glm::vec4 sampled{0.0f};
    glm::vec4 grid_size{0.0f};
    glm::mat4 field_from_world{1.0f};
    glm::vec4 noise{0.0f};
    glm::vec4 ramp_from{0.0f};
    glm::vec4 ramp_to{0.0f};
    glm::vec4 ramp_ends{0.0f};
    glm::vec4 shape{0.0f};
    glm::vec4 mask_size{0.0f};
    glm::mat4 mask_from_world{1.0f};
    glm::vec4 temperature_size{0.0f};
    glm::vec4 temperature{0.0f};
    glm::vec4 sigma_a{0.0f};
    glm::mat4 temperature_from_world{1.0f};
};
static_assert(sizeof(GpuMedium) == 512);

struct GpuBlobs {
    std::array<glm::vec4, kMaximumBlobs> centre_radius{};
    std::array<glm::vec4, kMaximumBlobs> weight{};
};

glm::mat4 features_from_world(const NoiseDensity& noise, double time_s) {
    const glm::dvec3 moved = -glm::dvec3(noise.wind_m_s) * time_s / static_cast<double>(noise.feature_m);
    return glm::scale(glm::translate(glm::mat4(1.0f), glm::vec3(moved)), glm::vec3(1.0f / noise.feature_m));
}

}  // namespace

/// What is about to be uploaded.
struct MediaBuffer::Blocks {
    std::array<GpuMedium, kMaximumMedia> media;
    GpuBlobs blobs;
    size_t blob_count = 0;
};

void MediaBuffer::warn_once(std::string_view what) {
    if (!warned_.emplace(what).second) return;
    log::warning("participating_media leaves out {}; the path tracer renders it", what);
}

void MediaBuffer::add(Blocks& blocks, const Medium& medium, const glm::mat4& box, double time_s) {
    GpuMedium& record = blocks.media[media_.size()];
    record.box_from_world = glm::inverse(box);
    record.sigma_s_phase =
        glm::vec4(medium.sigma_s_per_m * medium.scatter_factor, static_cast<float>(medium.phase.kind));
    record.sigma_t = glm::vec4(medium.sigma_s_per_m + medium.sigma_a_per_m, 0.0f);
    record.sigma_a = glm::vec4(medium.sigma_a_per_m, 0.0f);
    record.phase_parameters = medium.phase.parameters;
    record.emission_even = glm::vec4(medium.emission_cd_m2_per_m, 0.0f);
    record.shape.x = medium.shape == MediumShape::ellipsoid ? 1.0f : 0.0f;
    add_density(blocks, medium.density, time_s);
    if (const auto* product = std::get_if<ProductDensity>(&medium.density)) {
        add_density(blocks, *product->base, time_s);
        record.shape.y = 1.0f;
        if (product->layer)
            record.shape.z = product->layer->base_m, record.shape.w = 1.0f / product->layer->scale_height_m;
        if (product->mask) {
            record.mask_size = grid_size(*product->mask);
            record.mask_from_world = product->mask->to_volume * record.box_from_world;
        }
    }
    if (medium.temperature) {
        record.temperature_size = grid_size(medium.temperature->grid);
        record.temperature = glm::vec4(medium.temperature->grid.scale, medium.temperature->base_k, 0.0f, 0.0f);
        record.temperature_from_world = medium.temperature->grid.to_volume * record.box_from_world;
    }
    even_ = even_ && std::holds_alternative<ConstantDensity>(medium.density);
    media_.push_back(medium);
}

void MediaBuffer::add_density(Blocks& blocks, const DensityField& density, double time_s) {
    GpuMedium& record = blocks.media[media_.size()];
    if (std::holds_alternative<ConstantDensity>(density)) {
        record.emission_even.w = 1.0f;
    } else if (const auto* height = std::get_if<HeightDensity>(&density)) {
        record.blobs_height.z = height->base_m;
        record.blobs_height.w = 1.0f / height->scale_height_m;
    } else if (const auto* noise = std::get_if<NoiseDensity>(&density)) {
        record.sampled.x = static_cast<float>(std::clamp(noise->octaves, 1, 16));
        record.sampled.y = noise->coverage;
        record.field_from_world = features_from_world(*noise, time_s);
        const auto churn = static_cast<float>(static_cast<double>(noise->churn_per_s) * time_s);
        record.noise = glm::vec4(static_cast<float>(noise->kind), noise->swirl, churn, 1.0f / noise->feature_m);
    } else if (const auto* field = std::get_if<BlobDensity>(&density)) {
        add_blobs(blocks, *field);
    } else if (const auto* gradient = std::get_if<GradientDensity>(&density)) {
        record.ramp_from = glm::vec4(gradient->from, gradient->radial ? 2.0f : 1.0f);
        record.ramp_to =
            gradient->radial ? glm::vec4(gradient->inner, gradient->outer, 0.0f, 0.0f) : glm::vec4(gradient->to, 0.0f);
        record.ramp_ends = glm::vec4(gradient->start, gradient->end, 0.0f, 0.0f);
    } else if (const auto* grid = std::get_if<GridDensity>(&density); grid && grid->volume) {
        const glm::vec4 size = grid_size(*grid);
        record.sampled.z = grid->scale;
        record.sampled.w = size.w;
        record.grid_size = glm::vec4(glm::vec3(size), 0.0f);
        record.field_from_world = grid->to_volume * record.box_from_world;
    }
}

void MediaBuffer::add_blobs(Blocks& blocks, const BlobDensity& field) {
    GpuMedium& record = blocks.media[media_.size()];
    record.blobs_height.x = static_cast<float>(blocks.blob_count);
    for (const BlobDensity::Blob& blob : field.blobs) {
        if (blocks.blob_count == kMaximumBlobs) {
            warn_once(fmt::format("all blobs after the first {}", kMaximumBlobs));
            break;
        }
        if (!(blob.radius > 0.0f)) continue;
        blocks.blobs.centre_radius[blocks.blob_count] = glm::vec4(blob.centre, blob.radius);
        blocks.blobs.weight[blocks.blob_count++].x = blob.weight;
    }
    record.blobs_height.y = static_cast<float>(blocks.blob_count);
}

glm::vec4 MediaBuffer::grid_size(const GridDensity& grid) const {
    return grid.volume ? textures_.place(*grid.volume) : glm::vec4(0.0f);
}

const std::vector<Medium>& MediaBuffer::update(const RenderScene& scene, const MediaSettings& settings) {
    std::vector<const Medium*> shown;
    for (const Medium& medium : scene.media) {
        if (!settings.enabled || glm::determinant(glm::mat3(medium_box(medium, scene))) == 0.0f) continue;
        if (shown.size() == kMaximumMedia) {
            warn_once(fmt::format("all media after the first {}", kMaximumMedia));
            break;
        }
        shown.push_back(&medium);
    }
    if (const std::string reduced = textures_.update(shown); !reduced.empty()) warn_once(reduced);
    Blocks blocks;
    media_.clear();
    even_ = true;
    bounds_ = {};
    for (const Medium* medium : shown) {
        const glm::mat4 box = medium_box(*medium, scene);
        add(blocks, *medium, box, scene.time_s);
        bounds_.merge(Bounds{glm::vec3(-0.5f), glm::vec3(0.5f)}.transformed(box));
    }
    plan_.update(scene, media_, settings);
    if (!media_.empty() && has_environment(scene)) environment_.update(scene, media_);
    const std::string_view media_bytes(reinterpret_cast<const char*>(blocks.media.data()),
                                       media_.size() * sizeof(GpuMedium));
    const std::string_view blob_bytes(reinterpret_cast<const char*>(&blocks.blobs), sizeof(blocks.blobs));
    if (buffer_.name() == 0) {
        buffer_ = gpu::Buffer(sizeof(blocks.media), nullptr, "media");
        blobs_ = gpu::Buffer(sizeof(blocks.blobs), nullptr, "media blobs");
    }
    std::string bytes = std::string(media_bytes) + std::string(blob_bytes);
    if (bytes == uploaded_) return media_;
    uploaded_ = std::move(bytes);
    if (!media_bytes.empty()) buffer_.update(0, media_bytes.size(), media_bytes.data());
    blobs_.update(0, blob_bytes.size(), blob_bytes.data());
    return media_;
}

void MediaBuffer::bind(const gpu::Program& program, int light_steps) const {
    program.block("Media", buffer_);
    program.block("MediaBlobs", blobs_);
    program.set("media_count", static_cast<int>(media_.size()));
    program.set("media_light_steps", light_steps);
    const gpu::TextureDesc& grids = textures_.grids().desc();
    program.set("media_grids_voxel", 1.0f / glm::vec3(grids.width, grids.height, grids.layers));
    program.texture("media_grids", textures_.grids(), {.filter = gpu::Filter::linear});
}

void UploadPass::declare(PassDeclaration& declaration) {
    declaration.stage(Stage::shadow).keep();
}

void UploadPass::execute(PassContext& context) {
    media_->update(context.frame().scene, settings_);
}

}  // namespace tyndall::participating_media
