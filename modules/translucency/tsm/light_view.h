#pragma once
/// How a light looks at one object.

#include <glm/mat4x4.hpp>
#include <optional>

#include "scene/render_scene.h"

namespace tyndall::translucency {

/// A square window through which a light sees an object: parallel rays of directional lights, rays from a place of
/// others. Places in it are x / k, y / k and z, where k is z with perspective and 1 without, and z is metres along the
/// axis.
struct LightView {
    glm::mat4 view_from_world{1.0f};  ///< rigid
    glm::mat4 clip_from_world{1.0f};  ///< reversed-Z
    glm::vec2 low{0.0f};              ///< the window's corner, in x / k, y / k
    float size = 1.0f;                ///< of the window's sides, likewise
    float middle_z = 0.0f;            ///< of the object's middle
    bool perspective = false;

    /// Metres across the window at the object's middle.
    [[nodiscard]] float width_m() const { return perspective ? size * middle_z : size; }
};

/// All vertices of `mesh` placed by `transform`, seen by `light` in `texels` texels a side, of which one stays empty
/// all around. Nothing when the mesh reaches the light, or nearly so, or is not finite.
[[nodiscard]] std::optional<LightView> light_view(const Light& light, const Mesh& mesh, const glm::mat4& transform,
                                                  int texels);

}  // namespace tyndall::translucency
