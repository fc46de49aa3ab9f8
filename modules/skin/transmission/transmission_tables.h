#pragma once
/// What comes through thin parts, as shaders look it up (shaders/transmission/transmitted.glsl).

#include <memory>
#include <vector>

#include "gpu/gpu.h"
#include "scene/render_scene.h"

namespace tyndall::skin {

/// Shares by thickness of all tables of a scene, and which surface has which.
class TransmissionTables {
 public:
    /// Entry i of a row is the share at reach (i / (kEntries - 1))^2.
    static constexpr int kEntries = 1024;

    /// Brings the tables to the scene and binds them.
    void bind(const gpu::Program& program, const RenderScene& scene);

 private:
    /// What a row of shares is made of.
    struct Source {
        std::shared_ptr<const physics::SlabTransmittance> through;
        physics::DiffusionProfile profile;  ///< counts without the former
        bool operator==(const Source&) const = default;
    };
    struct Row {
        Source source;
        float reach_m = 0.0f;
        float width_m =
            0.0f;  ///< where a quarter of what comes through nothing comes through, by the channel that goes farthest
        std::vector<glm::vec4> shares;
    };
    static Row make(const Source& source);
    const Row& row_of(const SurfaceDiffusion& diffusion, size_t& index);

    std::vector<Row> rows_;
    std::vector<glm::vec4> surface_texels_;
    gpu::Texture shares_, surfaces_;
};

}  // namespace tyndall::skin
