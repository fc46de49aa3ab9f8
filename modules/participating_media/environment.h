#pragma once
/// Light from all around, as media scatter it: the whole-scene light probe or, without one, the sky.

#include <glm/mat3x3.hpp>
#include <vector>

#include "gpu/gpu.h"
#include "physics/physics.h"
#include "scene/render_scene.h"

namespace tyndall::participating_media {

/// The scene has such light, and does not turn it into lights.
[[nodiscard]] bool has_environment(const RenderScene& scene);

/// Its spherical harmonics up to the second band, and how media's phase functions turn them into scattered light. Boxed
/// probes keep it out of their boxes: what they show is surfaces' light, which single scattering leaves out.
class EnvironmentLight {
 public:
    /// Projects the image when it is another. `media` are those that are rendered.
    void update(const RenderScene& scene, const std::vector<Medium>& media);
    /// Sets what shaders/environment.glsl declares.
    void bind(const gpu::Program& program) const;

 private:
    struct Box {
        glm::mat4 local_from_world{1.0f};
        glm::vec4 extent_blend{0.0f};
    };
    /// What a medium's bands were made of.
    struct Phase {
        Phase() = default;
        explicit Phase(const PhaseFunction& phase)
            : kind(static_cast<int>(phase.kind)),
              parameters(phase.parameters),
              table(phase.table ? phase.table->id : 0) {}
        bool operator==(const Phase&) const = default;
        int kind = -1;
        glm::vec4 parameters{0.0f};
        uint64_t table = 0;
    };
    static constexpr size_t kMostBoxes = 8;
    void weigh_directions();

    uint64_t image_ = 0;
    physics::Sh9 image_harmonics_{};
    physics::Sh9 harmonics_{};  ///< scaled
    glm::mat3 image_from_world_{1.0f};
    std::vector<glm::vec4> directions_;  ///< xyz in the world
    std::vector<glm::vec3> weights_;     ///< of each, per channel; they add up to 1
    std::vector<Phase> phases_;
    std::vector<glm::vec3> bands_;  ///< of each medium's phase function
    std::vector<Box> boxes_;
};

}  // namespace tyndall::participating_media
