#include "seen_rectangle.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace tyndall::skin {

float far_depth(const Bounds& bounds, const Frame& frame) {
    float farthest = 0.0f;
    for (int i = 0; i < 8; ++i) {
        const glm::vec3 corner((i & 1) != 0 ? bounds.high.x : bounds.low.x, (i & 2) != 0 ? bounds.high.y : bounds.low.y,
                               (i & 4) != 0 ? bounds.high.z : bounds.low.z);
        farthest = std::max(farthest, (frame.block.view_projection * glm::vec4(corner, 1.0f)).w);
    }
    return farthest > 0.0f ? 0.999f * std::min(frame.block.eye_near.w / farthest, 1.0f) : 0.0f;
}

float nearest_pixel_m(const Bounds& bounds, const Frame& frame) {
    const glm::vec3 eye(frame.block.eye_near);
    const float distance = glm::distance(eye, glm::clamp(eye, bounds.low, bounds.high));
    return std::max(distance, frame.block.eye_near.w) * 2.0f * frame.block.tan_half_fov_exposure.y /
           frame.block.size_time.y;
}

Within::Within(glm::ivec2 low, glm::ivec2 high, float far, BlendState blend) : state_(DepthState::in_front, blend) {
    glEnable(GL_SCISSOR_TEST);
    glScissor(low.x, low.y, high.x - low.x, high.y - low.y);
    glDepthRangef(far, far);
}

Within::~Within() {
    glDepthRangef(0.0f, 1.0f);
    glDisable(GL_SCISSOR_TEST);
}

}  // namespace tyndall::skin
