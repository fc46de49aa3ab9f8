#include "render/frame_block.h"

#include <cmath>

#include "physics/physics.h"

namespace tyndall {
namespace {

/// Reversed-Z with an infinite far plane: depth = near / distance.
glm::mat4 reversed_perspective(float tan_half_x, float tan_half_y, float near) {
    glm::mat4 projection(0.0f);
    projection[0][0] = 1.0f / tan_half_x;
    projection[1][1] = 1.0f / tan_half_y;
    projection[2][3] = -1.0f;
    projection[3][2] = near;
    return projection;
}

}  // namespace

FrameBlock make_frame_block(const Camera& camera, glm::ivec2 size, double time_s, uint64_t frame) {
    const float tan_half_y = std::tan(0.5f * camera.vertical_fov);
    const float tan_half_x = tan_half_y * float(size.x) / float(size.y);
    FrameBlock block{};
    block.view = glm::inverse(camera.transform);
    block.projection = reversed_perspective(tan_half_x, tan_half_y, camera.near_m);
    block.view_projection = block.projection * block.view;
    block.inverse_view_projection = glm::inverse(block.view_projection);
    block.previous_view_projection = block.view_projection;
    block.eye_near = glm::vec4(glm::vec3(camera.transform[3]), camera.near_m);
    block.size_time = glm::vec4(float(size.x), float(size.y), float(time_s), float(frame % 1024));
    const float exposure = camera.exposure ? *camera.exposure : physics::exposure_from_ev100(camera.ev100);
    block.tan_half_fov_exposure = glm::vec4(tan_half_x, tan_half_y, exposure, 0.0f);
    return block;
}

void FrameBlockBuffer::update(const RenderScene& scene, glm::ivec2 size) {
    const glm::mat4 previous = block_.view_projection;
    block_ = make_frame_block(scene.camera, size, scene.time_s, scene.frame);
    if (has_previous_ && !scene.camera_cut) block_.previous_view_projection = previous;
    has_previous_ = true;
    if (buffer_.size() == 0) buffer_ = gpu::Buffer(sizeof(FrameBlock), nullptr, "FrameBlock");
    buffer_.update(0, sizeof(FrameBlock), &block_);
}

}  // namespace tyndall
