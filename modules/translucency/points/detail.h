#pragma once
/// How many points an object is worth.

#include "render/frame.h"
#include "scene/render_scene.h"

namespace tyndall::translucency {

/// How many points keep `pixels` pixels from each other where the surface, of `area` m2, is nearest to the eye;
/// infinite for 0 pixels.
[[nodiscard]] float points_worth(const Surface& surface, float area, const FrameBlock& frame, float pixels);

/// Levels of a cloud of at least so many points, at most `most`. What the object had `before` (0 = nothing) stays
/// until it is half a level too few or one and a half too many, so that a camera that trembles changes nothing.
[[nodiscard]] int levels_for(float points, int before, int most);

}  // namespace tyndall::translucency
