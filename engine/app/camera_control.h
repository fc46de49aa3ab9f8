#pragma once
/// Walking and flying with the keyboard, mouse and gamepad.

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "app/walker.h"

namespace tyndall {

/// What the user wants in this frame, already translated from keys and sticks.
struct CameraWish {
    glm::vec3 move{0.0f};      ///< right, up, forward; each -1..1
    glm::vec2 look_rad{0.0f};  ///< turn to the right, look up
    float speed = 1.0f;        ///< factor on the walking or flying speed
    bool jump = false;
};

enum class CameraMode { walk, fly };

/// Holds position and direction of the viewer between frames.
class CameraControl {
 public:
    /// Takes over a camera's placement (columns right, up, back, position), and stands or floats there.
    void set(const glm::mat4& transform, Walker& walker);
    void set_mode(CameraMode mode, Walker& walker);
    [[nodiscard]] CameraMode mode() const { return mode_; }
    /// Advances by `seconds`; walking falls back to flying where the level has no colliders.
    void update(const CameraWish& wish, float seconds, Walker& walker);
    /// Rigid placement of the camera.
    [[nodiscard]] glm::mat4 transform() const;

    float walk_m_per_s = 1.6f;
    float fly_m_per_s = 4.0f;

 private:
    glm::vec3 eye_{0.0f};
    float yaw_ = 0.0f;    ///< radians around +Y; 0 looks along -Z
    float pitch_ = 0.0f;  ///< radians; positive looks up
    CameraMode mode_ = CameraMode::walk;
};

}  // namespace tyndall
