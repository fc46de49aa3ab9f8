#pragma once
/// A mesh laid out for diffusion in texture space, and the maps that its surfaces are lit in.

#include <array>
#include <glm/mat3x3.hpp>
#include <glm/vec4.hpp>
#include <memory>
#include <string>

#include "texture_space/lobe_blurs.h"
#include "texture_space/surface_finish.h"

namespace tyndall::skin {

enum class MapTechnique { lobes, taps };

/// What maps are made for. Surfaces that agree use the same maps in turn.
struct MapKey {
    uint64_t mesh = 0;
    int size = 0;
    MapTechnique technique = MapTechnique::lobes;
    std::array<int, 6> stretch{};  ///< of the transform, in thousandths
    auto operator<=>(const MapKey&) const = default;
};

/// A transform's lengths as a scale and what differs from it: metres are `scale` times lengths after `shape`.
struct Stretch {
    float scale = 1.0f;
    glm::mat3 shape{1.0f};
    std::array<int, 6> key{};
};
[[nodiscard]] Stretch stretch_of(const glm::mat4& transform);

class SurfaceMaps {
 public:
    SurfaceMaps(const Mesh& mesh, const MapKey& key, const glm::mat3& shape);

    [[nodiscard]] const GpuAtlas& atlas() const { return blurs_ ? blurs_->atlas() : *atlas_; }
    [[nodiscard]] AtlasChunks& chunks() { return *chunks_; }
    /// What is to be spread: all at first.
    void choose(const ChunkSet& set);
    /// The map to be lit; its alpha is the chart's number.
    [[nodiscard]] const gpu::Texture& light() const { return blurs_ ? blurs_->light() : light_; }
    /// Spreads what has been lit. `profile`: metres of the map.
    void spread(gpu::ShaderLibrary& shaders, const physics::DiffusionProfile& profile);
    [[nodiscard]] const gpu::Texture& result() const { return blurs_ ? blurs_->result() : result_; }
    /// From UVs to 0..1 over the map: scale, offset.
    [[nodiscard]] glm::vec4 map_from_uv() const;
    [[nodiscard]] const glm::vec2& tile() const { return tile_; }
    /// Side of a mean texel, in metres of the map.
    [[nodiscard]] float texel_m() const { return texel_m_; }

    SurfaceFinish finish;
    std::string made_from;  ///< all that the result depends on ...
    ChunkSet made;          ///< ... and where it is

 private:
    std::unique_ptr<LobeBlurs> blurs_;
    std::unique_ptr<GpuAtlas> atlas_;  ///< of taps, as the three below
    gpu::Texture light_, result_;
    ChunkList chosen_;
    std::unique_ptr<AtlasChunks> chunks_;
    glm::vec2 tile_{0.0f};
    float texel_m_ = 0.0f;
};

}  // namespace tyndall::skin
