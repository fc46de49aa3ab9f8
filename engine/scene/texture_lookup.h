#pragma once
/// Textures on the processor, at full resolution.

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include "scene/render_scene.h"

namespace tyndall {

/// Bilinear (or nearest, as the texture asks), wrapped, decoded into the working space. Missing channels are 0, missing
/// alpha is 1. `uv` (0, 0) is the top left corner of the picture.
[[nodiscard]] glm::vec4 sample_texture(const TextureAsset& texture, glm::vec2 uv, TextureWrap wrap_u,
                                       TextureWrap wrap_v);

}  // namespace tyndall
