#include "render/material_table.h"

#include <algorithm>
#include <array>

#include "render/seams.h"

namespace tyndall {
namespace {

/// Order of the maps in `MaterialRecord::uv_rows`: that of the features' bits.
constexpr size_t kMaps = 10;
constexpr std::array<const char*, 15> kDefines{"BASE_COLOUR_MAP",
                                               "METALLIC_ROUGHNESS_MAP",
                                               "NORMAL_MAP",
                                               "OCCLUSION_MAP",
                                               "EMISSIVE_MAP",
                                               "SPECULAR_MAP",
                                               "SPECULAR_COLOUR_MAP",
                                               "DIFFUSE_TRANSMISSION_MAP",
                                               "DIFFUSE_TRANSMISSION_COLOUR_MAP",
                                               "PAINT_MAP",
                                               "SHARED_OCCLUSION",
                                               "UV_TRANSFORM",
                                               "ALPHA_MASK",
                                               "DIFFUSE_TRANSMISSION",
                                               "PAINT"};
constexpr std::array<const char*, kMaps> kSamplers{"base_colour_map",
                                                   "metallic_roughness_map",
                                                   "normal_map",
                                                   "occlusion_map",
                                                   "emissive_map",
                                                   "specular_map",
                                                   "specular_colour_map",
                                                   "diffuse_transmission_map",
                                                   "diffuse_transmission_colour_map",
                                                   "paint_map"};

std::array<const TextureSlot*, kMaps> slots_of(const Material& m) {
    return {&m.base_colour_texture,
            &m.metallic_roughness_texture,
            &m.normal_texture,
            &m.occlusion_texture,
            &m.emissive_texture,
            &m.specular_texture,
            &m.specular_colour_texture,
            &m.diffuse_transmission_texture,
            &m.diffuse_transmission_colour_texture,
            &m.paint_texture};
}

/// Maps that only count where diffuse light goes through.
constexpr uint32_t kThroughMaps = kDiffuseTransmissionMap | kDiffuseTransmissionColourMap;

bool same_lookup(const TextureSlot& a, const TextureSlot& b) {
    return a.texture == b.texture && a.uv_set == b.uv_set && a.uv_transform == b.uv_transform;
}

uint32_t features_of(const Material& material) {
    const auto slots = slots_of(material);
    uint32_t features = material.alpha_mode == AlphaMode::opaque ? 0u : uint32_t{kAlphaMask};
    const bool through = material.diffuse_transmission > 0.0f;
    const bool painted = material.paint_cover > 0.0f;
    if (through) features |= kDiffuseTransmission;
    if (painted) features |= kPaint;
    for (size_t i = 0; i < kMaps; ++i) {
        if (!slots[i]->texture || (!through && (kThroughMaps & (1u << i)) != 0) || (!painted && (1u << i) == kPaintMap))
            continue;
        features |= 1u << i;
        if (slots[i]->uv_set != 0 || slots[i]->uv_transform != glm::mat3(1.0f)) features |= kUvTransform;
    }
    if ((features & kOcclusionMap) != 0 &&
        same_lookup(material.occlusion_texture, material.metallic_roughness_texture)) {
        features = (features & ~uint32_t{kOcclusionMap}) | kSharedOcclusion;
    }
    return features;
}

/// Where diffuse light goes through, "thin": with nothing that knows it the sum of both sides comes back.
std::string shading_model_of(const Material& material) {
    const bool thin = material.diffuse_transmission > 0.0f && material.shading_model == "standard";
    return thin ? "thin" : material.shading_model;
}

MaterialRecord record_of(const Material& m, uint32_t shading_model) {
    MaterialRecord record{};
    record.base_colour = m.base_colour;
    record.emissive_normal_scale = glm::vec4(m.emissive, m.normal_scale);
    record.metallic_roughness_occlusion_cutoff =
        glm::vec4(m.metallic, m.roughness, m.occlusion_strength, m.alpha_cutoff);
    record.specular_colour_weight = glm::vec4(m.specular_colour, m.specular);
    record.ior_model = glm::vec4(m.ior, float(shading_model), 0.0f, 0.0f);
    record.diffuse_transmission = glm::vec4(m.diffuse_transmission_colour, m.diffuse_transmission);
    record.paint = glm::vec4(m.paint_colour, m.paint_cover);
    const auto slots = slots_of(m);
    for (size_t i = 0; i < kMaps; ++i) {
        const glm::mat3 rows = glm::transpose(slots[i]->uv_transform);
        record.uv_rows[2 * i] = glm::vec4(rows[0], float(slots[i]->uv_set));
        record.uv_rows[2 * i + 1] = glm::vec4(rows[1], 0.0f);
    }
    return record;
}

}  // namespace

std::vector<std::string> feature_defines(uint32_t features) {
    std::vector<std::string> defines;
    for (size_t i = 0; i < kDefines.size(); ++i)
        if ((features & (1u << i)) != 0) defines.emplace_back(kDefines[i]);
    return defines;
}

void MaterialTable::begin() {
    entries_.clear();
    records_.clear();
    index_.clear();
}

uint32_t MaterialTable::add(const Material& material, const Seams& seams, TextureCache& textures) {
    const auto [found, is_new] = index_.try_emplace(&material, uint32_t(entries_.size()));
    if (!is_new) return found->second;
    entries_.push_back({&material, features_of(material)});
    records_.push_back(record_of(material, seams.shading_model(shading_model_of(material))));
    for (const TextureSlot* slot : slots_of(material))
        if (slot->texture) textures.get(*slot->texture);
    return found->second;
}

void MaterialTable::upload() {
    const size_t bytes = records_.size() * sizeof(MaterialRecord);
    if (bytes == 0) return;
    if (bytes > buffer_.size()) buffer_ = gpu::Buffer(bytes + bytes / 2, nullptr, "Materials");
    buffer_.update(0, bytes, records_.data());
}

void MaterialTable::bind(uint32_t index, const gpu::Program& program, TextureCache& textures) const {
    program.block("MaterialBlock", buffer_, index * sizeof(MaterialRecord), sizeof(MaterialRecord));
    const auto slots = slots_of(*entries_[index].material);
    for (size_t i = 0; i < kMaps; ++i) {
        if ((entries_[index].features & (1u << i)) == 0) continue;
        const TextureAsset& asset = *slots[i]->texture;
        program.texture(kSamplers[i], textures.get(asset), TextureCache::sampler(asset));
    }
}

}  // namespace tyndall
