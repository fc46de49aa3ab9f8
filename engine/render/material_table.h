#pragma once
/// Materials as the shaders read them, and which variant of a program each needs.

#include <string>
#include <unordered_map>
#include <vector>

#include "gpu/gpu.h"
#include "render/texture_cache.h"
#include "scene/render_scene.h"

namespace tyndall {

class Seams;

/// What a program must be compiled with for a material: one bit, one #define. A texture that is not there costs
/// nothing.
enum MaterialFeature : uint32_t {
    kBaseColourMap = 1u << 0,
    kMetallicRoughnessMap = 1u << 1,
    kNormalMap = 1u << 2,
    kOcclusionMap = 1u << 3,
    kEmissiveMap = 1u << 4,
    kSpecularMap = 1u << 5,
    kSpecularColourMap = 1u << 6,
    kDiffuseTransmissionMap = 1u << 7,
    kDiffuseTransmissionColourMap = 1u << 8,
    kPaintMap = 1u << 9,
    kSharedOcclusion = 1u << 10,  ///< occlusion is the red of the metallic-roughness map
    kUvTransform = 1u << 11,      ///< a map uses the second UV set or a transform
    kAlphaMask = 1u << 12,
    kDiffuseTransmission = 1u << 13,  ///< diffuse light goes through
    kPaint = 1u << 14,                ///< an interior's boundary is painted
};
/// The #define names of the features' bits.
[[nodiscard]] std::vector<std::string> feature_defines(uint32_t features);

/// The uniform block "MaterialBlock" of render/shaders/material_maps.glsl; as large as any driver's alignment of
/// blocks.
struct alignas(256) MaterialRecord {
    glm::vec4 base_colour;
    glm::vec4 emissive_normal_scale;
    glm::vec4 metallic_roughness_occlusion_cutoff;
    glm::vec4 specular_colour_weight;
    glm::vec4 ior_model;             ///< x index of refraction, y number of the shading model
    glm::vec4 diffuse_transmission;  ///< rgb colour of what goes through, a its share
    glm::vec4 paint;                 ///< rgb colour of what is painted over an interior, a its share
    glm::vec4 uv_rows[20];
};

/// A frame's materials: records by index.
class MaterialTable {
 public:
    /// Forgets the last frame's materials.
    void begin();
    /// The index of a material's record, added when new in this frame.
    uint32_t add(const Material& material, const Seams& seams, TextureCache& textures);
    void upload();

    [[nodiscard]] uint32_t features(uint32_t index) const { return entries_[index].features; }
    [[nodiscard]] bool double_sided(uint32_t index) const { return entries_[index].material->double_sided; }
    [[nodiscard]] uint64_t id(uint32_t index) const { return entries_[index].material->id; }
    /// Binds the block and the textures of the material.
    void bind(uint32_t index, const gpu::Program& program, TextureCache& textures) const;

 private:
    struct Entry {
        const Material* material;
        uint32_t features;
    };
    std::vector<Entry> entries_;
    std::vector<MaterialRecord> records_;
    std::unordered_map<const Material*, uint32_t> index_;
    gpu::Buffer buffer_;
};

}  // namespace tyndall
