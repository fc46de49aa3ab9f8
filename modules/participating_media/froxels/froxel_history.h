#pragma once
/// What of the last frame's froxels still holds.

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <string>
#include <vector>

#include "froxels/froxel_grid.h"
#include "gpu/gpu.h"
#include "media_buffer.h"
#include "render/frame.h"

namespace tyndall::participating_media {

/// Remembers the last frame's view, lights and media, and says what changed.
class FroxelHistory {
 public:
    /// Once a frame. `usable` = the froxels of the last frame are at hand.
    void update(const Frame& frame, const MediaBuffer& media, const std::vector<Term>& terms, const FroxelGrid& grid,
                bool usable);
    void forget() { known_ = false; }
    /// 0 nothing holds, 1 seen from another view, 2 from the same: HISTORY of begin.comp.
    [[nodiscard]] int kind() const;
    /// Sets what begin.comp asks for.
    void bind(const gpu::Program& program) const;
    /// Frames since the last cut.
    [[nodiscard]] int frames() const { return frames_; }

 private:
    /// A light as far as its light in the froxels depends on it.
    struct LightState {
        glm::vec4 values[6];
        bool operator==(const LightState&) const = default;
    };
    void compare_lights(const Frame& frame, const std::vector<Term>& terms);
    void compare_casters(const Frame& frame);
    void add_dirty(const glm::vec4& sphere);

    static constexpr size_t kMostDirty = 16;  ///< as in begin.comp; beyond, everything is dirty
    bool known_ = false, has_ = false;
    int frames_ = 0;
    glm::mat4 view_projection_{1.0f}, previous_view_projection_{1.0f};
    glm::vec3 eye_{0.0f}, previous_eye_{0.0f};
    glm::vec4 depths_{0.0f}, previous_depths_{0.0f};
    std::vector<LightState> lights_;
    std::vector<Term> terms_;
    std::string media_;
    float least_weight_ = 1.0f;
    std::vector<glm::vec4> dirty_;
};

}  // namespace tyndall::participating_media
