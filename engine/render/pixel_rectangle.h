#pragma once
/// Where in the picture a solid can be seen.

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <vector>

#include "geometry/bounds.h"

namespace tyndall {

/// Pixels from `low` on, row 0 at the bottom.
struct PixelRectangle {
    glm::ivec2 low{0};
    glm::ivec2 size{0};
    [[nodiscard]] bool empty() const { return size.x <= 0 || size.y <= 0; }
};

/// Holds the box in a picture of `size` pixels: all of the picture where a corner is behind the eye.
[[nodiscard]] PixelRectangle pixels_of(const Bounds& world, const glm::mat4& view_projection, glm::ivec2 size);

/// The smallest that holds both; the other where one is empty.
[[nodiscard]] PixelRectangle united(const PixelRectangle& a, const PixelRectangle& b);
/// All other pixels of a picture of `size` pixels, in as few rectangles as it takes, none of them empty.
[[nodiscard]] std::vector<PixelRectangle> outside(const PixelRectangle& rectangle, glm::ivec2 size);

}  // namespace tyndall
