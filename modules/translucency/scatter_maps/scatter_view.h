#pragma once
/// How a light looks at a solid.

#include <glm/mat4x4.hpp>

#include "scene/render_scene.h"

namespace tyndall::translucency {

/// A square picture of a solid from a light: in parallel from a directional one, in perspective from others.
struct ScatterView {
    glm::vec3 origin{0.0f};  ///< the light, or the solid's middle
    glm::vec3 right{0.0f}, up{0.0f}, forward{0.0f};
    float half = 1.0f;  ///< half the picture's width: metres, or per metre of depth
    bool perspective = false;
    float depth = 0.0f;  ///< of the solid's middle along `forward`, metres
    float reach = 0.0f;  ///< the solid lies within so much of that depth

    [[nodiscard]] glm::mat4 clip_from_world() const;  ///< reversed-Z
    /// Half the width that the picture covers at the solid's middle, metres.
    [[nodiscard]] float half_m() const { return perspective ? half * depth : half; }
};

/// Holds all of the solid with a margin of a texel of `size`. A light that is so near, or inside, that the solid fills
/// more than 150 degrees sees only so much of it.
[[nodiscard]] ScatterView scatter_view(const Light& light, const Surface& surface, int size);

}  // namespace tyndall::translucency
