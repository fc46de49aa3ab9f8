#pragma once
/// Where a light stands on the screen.

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>

#include "scene/render_scene.h"

namespace tyndall::participating_media {

/// The point, in pixels, through which all epipolar lines go: the light's place on the screen, or, when the light is
/// behind the camera, the place opposite to it. Finite for lights in the camera's own plane: then far away.
[[nodiscard]] glm::vec2 epipole(const Light& light, const glm::mat4& view_projection, glm::ivec2 size);

}  // namespace tyndall::participating_media
