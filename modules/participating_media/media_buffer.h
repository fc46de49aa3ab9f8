#pragma once
/// The frame's media on the GPU, shared by the march and the two seam providers.

#include <glm/mat4x4.hpp>
#include <string>

#include "gpu/gpu.h"
#include "scene/render_scene.h"

namespace tyndall::participating_media {

/// The storage block "Media" of shaders/media.glsl. Makes its GL objects when first bound.
class MediaBuffer {
 public:
    /// Sets the block and the count on a program that includes media.glsl; uploads the scene's media when they changed.
    void bind(const gpu::Program& program, const RenderScene& scene, bool enabled);

 private:
    void update(const RenderScene& scene, bool enabled);
    gpu::Buffer buffer_;
    int count_ = 0;
    std::string uploaded_;  ///< the buffer's bytes
};

/// Placement of a medium's unit box in the world; the whole scene's bounds for MediumShape::whole_scene.
[[nodiscard]] glm::mat4 box_to_world(const Medium& medium, const RenderScene& scene);

}  // namespace tyndall::participating_media
