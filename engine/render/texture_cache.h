#pragma once
/// TextureAssets on the GPU.

#include <memory>
#include <unordered_map>

#include "gpu/gpu.h"
#include "scene/render_scene.h"

namespace tyndall {

/// Uploads each asset once, with mip-maps where its filter wants them, and frees what has not been asked for in a
/// while.
class TextureCache {
 public:
    /// The asset's texture, uploaded on first use: always four channels, v = 0 at the image's top.
    const gpu::Texture& get(const TextureAsset& asset);
    /// How materials sample it.
    [[nodiscard]] static gpu::SamplerDesc sampler(const TextureAsset& asset);
    /// Once a frame: frees textures unused for kKeptFrames.
    void collect();

 private:
    static constexpr uint64_t kKeptFrames = 120;
    struct Entry {
        gpu::Texture texture;
        uint64_t last_used = 0;
    };
    std::unordered_map<uint64_t, Entry> entries_;
    uint64_t frame_ = 0;
};

}  // namespace tyndall
