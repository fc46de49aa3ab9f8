#pragma once
/// The slides in front of lights, in one array texture.

#include <cstdint>
#include <vector>

#include "gpu/gpu.h"
#include "gpu/shader_library.h"
#include "scene/render_scene.h"

namespace tyndall {

class GpuScene;

/// Copies the lights' gobo images into the layers of one texture: linear transmittance, one common size, with mips.
class Gobos {
 public:
    /// Copies again when the set of images has changed. Images larger than 1024 texels a side, or than what keeps all
    /// of them within 64 MiB, are made smaller.
    void update(const RenderScene& scene, GpuScene& gpu_scene, gpu::ShaderLibrary& shaders);
    /// Layer of the image; -1 when it is null or unknown.
    [[nodiscard]] int layer_of(const TextureAsset* image) const;
    /// As "light_gobos".
    void bind(const gpu::Program& program) const;

 private:
    void copy(const TextureAsset& image, int layer, GpuScene& gpu_scene, gpu::ShaderLibrary& shaders);

    std::vector<uint64_t> images_;  ///< ids, in order of layers
    std::vector<const TextureAsset*> wanted_;
    gpu::Texture texture_;
};

}  // namespace tyndall
