#pragma once
/// What a surface's material does to light that enters it, for each texel of a map.

#include <string>

#include "gpu/gpu.h"
#include "gpu/shader_library.h"
#include "render/gpu_scene.h"
#include "texture_space/gpu_atlas.h"

namespace tyndall::skin {

/// A list along with the atlas' covered texels: base colour to a power, roughness; and occlusion.
class SurfaceFinish {
 public:
    /// Makes it anew when the material, the power or the atlas is another.
    void update(gpu::ShaderLibrary& shaders, GpuScene& scene, const Material& material, float pre_scatter,
                const GpuAtlas& atlas, const glm::vec2& tile);
    [[nodiscard]] const gpu::Texture& list() const { return list_; }
    [[nodiscard]] const gpu::Texture& occlusion() const { return occlusion_; }

 private:
    gpu::Texture list_, occlusion_;
    std::string made_from_;
};

/// The power that can be used: maps by another UV set than the light map's are not known there, and even colour cancels
/// out.
[[nodiscard]] float usable_pre_scatter(const Material& material, float wanted);
/// Sets the uniforms `NAME_rows[0..1]` (of a map's UV transform) and the texture `NAME`; white without a map.
void bind_slot(const gpu::Program& program, GpuScene& scene, const std::string& name, const TextureSlot& slot);

}  // namespace tyndall::skin
