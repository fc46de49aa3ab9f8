#pragma once
/// The camera as the shaders see it.

#include "render/frame.h"

namespace tyndall {

/// The view of a camera without its history; previous_view_projection equals view_projection.
[[nodiscard]] FrameBlock make_frame_block(const Camera& camera, glm::ivec2 size, double time_s, uint64_t frame);

/// FrameBlock on the GPU, with the last frame's view.
class FrameBlockBuffer {
 public:
    void update(const RenderScene& scene, glm::ivec2 size);
    [[nodiscard]] const FrameBlock& block() const { return block_; }
    [[nodiscard]] const gpu::Buffer& buffer() const { return buffer_; }

 private:
    FrameBlock block_{};
    gpu::Buffer buffer_;
    bool has_previous_ = false;
};

}  // namespace tyndall
