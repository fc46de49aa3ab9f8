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

PixelRectangle united(const PixelRectangle& a, const PixelRectangle& b) {
    if (a.empty()) return b;
    if (b.empty()) return a;
    const glm::ivec2 low = glm::min(a.low, b.low);
    return {low, glm::max(a.low + a.size, b.low + b.size) - low};
}

std::vector<PixelRectangle> outside(const PixelRectangle& rectangle, glm::ivec2 size) {
    if (rectangle.empty()) return {{glm::ivec2(0), size}};
    const glm::ivec2 low = rectangle.low, high = rectangle.low + rectangle.size;
    std::vector<PixelRectangle> around{{glm::ivec2(0), {size.x, low.y}},
                                       {{0, high.y}, {size.x, size.y - high.y}},
                                       {{0, low.y}, {low.x, rectangle.size.y}},
                                       {{high.x, low.y}, {size.x - high.x, rectangle.size.y}}};
    std::erase_if(around, [](const PixelRectangle& one) { return one.empty(); });
    return around;
}

}  // namespace tyndall
