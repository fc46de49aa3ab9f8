#pragma once
/// Whether what was marched in the last frame still holds.

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "media_buffer.h"
#include "render/frame.h"

namespace tyndall::participating_media {

/// Remembers the last frame's lights and media. The camera may move: what it saw is found again by its place.
class MarchHistory {
 public:
    /// Once a frame. `pixel_step` is that of what is marched.
    void update(const Frame& frame, const MediaBuffer& media, int pixel_step);
    /// Frames in a row in which no light, no caster of shadows and no medium changed; 0 = nothing holds. A cut ends
    /// them, too.
    [[nodiscard]] int frames() const { return frames_; }
    /// This frame must do without most of what was: nothing holds, or the camera moves or turns fast.
    [[nodiscard]] bool alone() const { return frames_ == 0 || fast_; }

 private:
    std::string lights_, media_;  ///< bytes
    glm::vec3 eye_{0.0f};
    glm::mat3 view_{0.0f};
    int frames_ = 0;
    bool fast_ = false;
};

}  // namespace tyndall::participating_media
