#pragma once
/// The part of the picture that a light can reach.

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>

#include "scene/render_scene.h"

namespace tyndall::participating_media {

/// Pixels from `low` on, row 0 at the bottom.
struct ScreenRectangle {
    glm::ivec2 low{0};
    glm::ivec2 size{0};
    [[nodiscard]] bool empty() const { return size.x <= 0 || size.y <= 0; }
};

/// Encloses the sphere of a light with a range, or is the whole picture of `size` pixels.
[[nodiscard]] ScreenRectangle light_rectangle(const Light& light, const glm::mat4& view_projection, glm::ivec2 size);

}  // namespace tyndall::participating_media
