#include "light_rectangle.h"

#include <glm/common.hpp>

namespace tyndall::participating_media {

ScreenRectangle light_rectangle(const Light& light, const glm::mat4& view_projection, glm::ivec2 size) {
    const ScreenRectangle all{glm::ivec2(0), size};
    if (light.kind == LightKind::directional || light.range_m <= 0.0f) return all;
    glm::vec2 low(1.0f), high(-1.0f);
    int behind = 0;
    for (int corner = 0; corner < 8; ++corner) {
        const glm::vec3 side((corner & 1) != 0 ? 1.0f : -1.0f, (corner & 2) != 0 ? 1.0f : -1.0f,
                             (corner & 4) != 0 ? 1.0f : -1.0f);
        const glm::vec4 clip = view_projection * glm::vec4(glm::vec3(light.transform[3]) + light.range_m * side, 1.0f);
        if (clip.w <= 1e-4f) {
            ++behind;
            continue;
        }
        low = glm::min(low, glm::vec2(clip) / clip.w);
        high = glm::max(high, glm::vec2(clip) / clip.w);
    }
    if (behind == 8) return {};
    if (behind > 0) return all;
    const glm::vec2 pixels(size);
    const glm::ivec2 first = glm::clamp(glm::ivec2(glm::floor((low * 0.5f + 0.5f) * pixels)), glm::ivec2(0), size);
    const glm::ivec2 last = glm::clamp(glm::ivec2(glm::ceil((high * 0.5f + 0.5f) * pixels)), glm::ivec2(0), size);
    return {first, last - first};
}

}  // namespace tyndall::participating_media
