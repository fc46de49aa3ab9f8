#pragma once
/// How a light looks at one object: what its translucent shadow map or subsurface scatter map is drawn with.
///
/// Each object has a window of its own, as large as it is: one map of a light for all objects would have to span the
/// room between them, and two bodies of 2 cm at 2 m from each other would share what 256 texels are for one.

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>

#include "gpu/gpu.h"
#include "render/gpu_scene.h"
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
    bool whole = false;  ///< it holds all of the object: the light is not in it or close to it

    /// Metres across the window at the object's middle.
    [[nodiscard]] float width_m() const { return perspective ? size * middle_z : size; }
};

/// All vertices of `mesh` placed by `transform`, seen by `light` in `texels` texels a side, of which two stay empty all
/// around. A light that is so near, or inside, that the object fills more than 150 degrees sees only so much of it. Not
/// whole either when the mesh has no size or is not finite.
[[nodiscard]] LightView light_view(const Light& light, const Mesh& mesh, const glm::mat4& transform, int texels);

/// The uniform block "LightView" of shaders/light_view.glsl.
class LightViewBlock {
 public:
    void update(const LightView& view, int texels);
    void bind(const gpu::Program& program) const { program.block("LightView", buffer_); }

 private:
    gpu::Buffer buffer_;
};

/// Draws the object with shaders/light_view.vert, the program and its state being in use.
void draw_in(const LightView& view, const gpu::Program& program, GpuScene& scene, const Surface& surface);

}  // namespace tyndall::translucency
