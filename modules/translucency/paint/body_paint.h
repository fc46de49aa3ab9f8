#pragma once
/// A body's paint on the GPU.

#include <tuple>

#include "body_space.h"
#include "gpu/gpu.h"
#include "paint/paint_grid.h"
#include "render/kept.h"

namespace tyndall::translucency {

[[nodiscard]] inline bool is_painted(const Surface& surface) {
    return surface.material && surface.material->paint_cover > 0.0f;
}

/// A PaintGrid in textures.
struct BodyPaint {
    gpu::Texture ends, even;
    glm::mat4 grid_from_shape{1.0f};  ///< from the stretched mesh's space
    glm::vec3 shape{1.0f};
    uint64_t number = 0;  ///< no other has it; 0 before it is made
    bool closed = false;  ///< the body encloses something
};

/// Paint of all bodies, each made once.
class PaintStore {
 public:
    /// Null where nothing is painted, and of a mesh without area. It stays good while it is asked for.
    [[nodiscard]] const BodyPaint* of(const Surface& surface, Model model);
    /// Another where the paint is another; 0 without.
    [[nodiscard]] uint64_t number(const Surface& surface, Model model);
    void end_frame() { kept_.end_frame(); }

 private:
    using Numbers = std::array<float, 17>;
    Kept<std::tuple<ShapeKey, Model, uint64_t, Numbers>, BodyPaint> kept_;
    uint64_t made_ = 0;
};

/// What shaders/paint.glsl reads. Without paint all is open.
class PaintBinding {
 public:
    void set(const BodyPaint* paint, const Surface& surface);
    void bind(const gpu::Program& program) const;

 private:
    const BodyPaint* paint_ = nullptr;
    glm::mat4 grid_from_world_{1.0f};
    gpu::Texture open_;
};

}  // namespace tyndall::translucency
