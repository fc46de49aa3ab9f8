#pragma once
/// The GGX lobe's directional albedo on the GPU.

#include "gpu/gpu.h"

namespace tyndall {

/// The table of physics/tables.h as a texture, made on first use; render/shaders/specular_table.glsl reads it.
class SpecularTableTexture {
 public:
    /// Binds it as "specular_table".
    void bind(const gpu::Program& program);

 private:
    gpu::Texture texture_;
};

}  // namespace tyndall
