#pragma once
/// An interior and its paint, for every technique's programs.

#include "gpu/gpu.h"
#include "interior_block.h"
#include "paint/body_paint.h"

namespace tyndall::translucency {

/// An interior on the GPU, and what is painted over it.
class InteriorBuffers {
 public:
    /// True when they were made anew since something changed.
    bool update(const InteriorKey& key);
    /// In every frame, before they are bound (PaintStore::of).
    void paint(const BodyPaint* paint, const Surface& surface) { paint_.set(paint, surface); }
    void bind(const gpu::Program& program) const;
    /// What they hold of the interior.
    [[nodiscard]] const InteriorBlock& block() const { return made_; }

 private:
    InteriorKey key_;
    InteriorBlock made_{};
    gpu::Buffer block_;
    PaintBinding paint_;
};

}  // namespace tyndall::translucency
