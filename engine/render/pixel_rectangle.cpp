#include "render/pixel_rectangle.h"

namespace tyndall {

PixelRectangle pixels_of(const Bounds& world, const glm::mat4& view_projection, glm::ivec2 size) {
    if (world.empty()) return {};
    glm::vec2 low(1.0f), high(-1.0f);
    for (int i = 0; i < 8; ++i) {
        const glm::vec3 corner((i & 1) != 0 ? world.high.x : world.low.x, (i & 2) != 0 ? world.high.y : world.low.y,
                               (i & 4) != 0 ? world.high.z : world.low.z);
        const glm::vec4 clip = view_projection * glm::vec4(corner, 1.0f);
        if (clip.w <= 1e-6f) return {glm::ivec2(0), size};
        low = glm::min(low, glm::vec2(clip) / clip.w);
        high = glm::max(high, glm::vec2(clip) / clip.w);
    }
    const glm::vec2 half = 0.5f * glm::vec2(size);
    const glm::ivec2 first(glm::floor((glm::clamp(low, -1.0f, 1.0f) + 1.0f) * half));
    const glm::ivec2 last(glm::ceil((glm::clamp(high, -1.0f, 1.0f) + 1.0f) * half));
    return {first, last - first};
}

}  // namespace tyndall
