#pragma once
/// Skin drawn once more, where it is what is seen.

#include "render/frame.h"

namespace tyndall::skin {

/// Draws a surface's mesh where its depth is the picture's. `program` is in use and has the vertex shader
/// skin/surface.vert; the depth target is bound.
void draw_seen_mesh(const gpu::Program& program, const Surface& surface, Frame& frame);

}  // namespace tyndall::skin
