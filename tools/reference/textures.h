#pragma once
/// Textures at full resolution: the tracer's samples filter them.

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include "reference/geometry.h"

namespace tyndall::reference {

/// Bilinear (or nearest, as the texture asks), wrapped, decoded into the working space. Missing channels are 0, missing
/// alpha is 1. `uv` (0, 0) is the top left corner of the picture.
[[nodiscard]] glm::vec4 sample_texture(const TextureAsset& texture, glm::vec2 uv, TextureWrap wrap_u,
                                       TextureWrap wrap_v);
/// The slot's texture at a surface point, or white.
[[nodiscard]] glm::vec4 sample_slot(const TextureSlot& slot, const SurfacePoint& point);
/// A light probe's or sky's image in a unit direction of its own frame.
[[nodiscard]] glm::vec3 sample_equirect(const TextureAsset& texture, const glm::vec3& direction);

}  // namespace tyndall::reference
