#pragma once
/// Textures at full resolution (scene/texture_lookup.h): the tracer's samples filter them.

#include <glm/vec4.hpp>

#include "reference/geometry.h"

namespace tyndall::reference {

/// The slot's texture at a surface point, or white.
[[nodiscard]] glm::vec4 sample_slot(const TextureSlot& slot, const SurfacePoint& point);
/// A light probe's or sky's image in a unit direction of its own frame.
[[nodiscard]] glm::vec3 sample_equirect(const TextureAsset& texture, const glm::vec3& direction);

}  // namespace tyndall::reference
