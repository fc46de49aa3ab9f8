#pragma once
/// The scene's lights as shaders read them (render/shaders/lights.glsl).

#include <vector>

#include "gpu/gpu.h"
#include "render/frame.h"
#include "render/gobos.h"

namespace tyndall {

/// The block "Lights" and the gobos.
class LightBuffer {
 public:
    /// Once a frame, after ShadowMaps::prepare.
    void update(const RenderScene& scene, const ShadowMaps& shadow_maps, GpuScene& gpu_scene,
                gpu::ShaderLibrary& shaders);
    /// The block "Lights" and the texture "light_gobos".
    void bind(const gpu::Program& program) const;
    /// The block "Light": one of them.
    void bind_one(const gpu::Program& program, size_t light) const;
    /// One for each of the scene's lights; at least one.
    [[nodiscard]] const std::vector<GpuLight>& lights() const { return lights_; }

 private:
    Gobos gobos_;
    std::vector<GpuLight> lights_;
    gpu::Buffer buffer_;
};

}  // namespace tyndall
