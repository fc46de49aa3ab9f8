#pragma once
/// What the shading model "interior" (shaders/quick/model.glsl) knows of the bodies of a frame.

#include <vector>

#include "gpu/gpu.h"
#include "quick/quick_body.h"
#include "render/seams.h"
#include "seen_surface.h"

namespace tyndall::translucency {

/// As the shader has them; a body that is not in the table is 0 and lit plainly.
enum class QuickKind { wrap = 1, thickness = 2 };

/// A table in a texture, with a column for each surface of the scene.
class QuickTable {
 public:
    /// Forgets the last frame's bodies.
    void begin(size_t surfaces);
    /// `lobe`: distortion, power, ambient, scale of the technique thickness.
    void add(const SeenSurface& seen, const QuickBody& body, QuickKind kind, const glm::vec4& lobe);
    void upload();

    /// Of the bodies that were added.
    [[nodiscard]] const ShadingModelUse& use() const { return use_; }
    void bind(const gpu::Program& program) const;

 private:
    static constexpr size_t kRows = 4;

    ShadingModelUse use_;
    size_t width_ = 0;
    std::vector<glm::vec4> rows_, uploaded_rows_;
    std::vector<const QuickBody*> bodies_;
    std::vector<uint64_t> versions_, uploaded_versions_;
    gpu::Texture surfaces_, patterns_;
};

}  // namespace tyndall::translucency
