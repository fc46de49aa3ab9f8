#pragma once
/// Full-screen passes that draw where surfaces can be seen and nowhere else.

#include <glm/vec2.hpp>

#include "geometry/bounds.h"
#include "render/draw_state.h"
#include "render/frame.h"

namespace tyndall::skin {

/// Depth of the box's farthest corner, reversed-Z; 0 where it reaches behind the eye.
[[nodiscard]] float far_depth(const Bounds& bounds, const Frame& frame);

/// Metres of a pixel across the line of sight, where the box is nearest to the eye.
[[nodiscard]] float nearest_pixel_m(const Bounds& bounds, const Frame& frame);

/// A full-screen triangle draws within a rectangle, and where something is nearer than a depth, for the time of a
/// scope. The depth target must be bound. Tests before the shader are what software renderers skip pixels by.
class Within {
 public:
    Within(glm::ivec2 low, glm::ivec2 high, float far, BlendState blend = BlendState::off);
    ~Within();
    Within(const Within&) = delete;
    Within& operator=(const Within&) = delete;

 private:
    DrawState state_;
};

}  // namespace tyndall::skin
