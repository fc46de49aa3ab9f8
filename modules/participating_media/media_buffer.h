#pragma once
/// The frame's media on the GPU and who renders them, shared by the solvers and the two seam providers.

#include <glm/mat4x4.hpp>
#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "environment.h"
#include "gpu/gpu.h"
#include "media_settings.h"
#include "media_textures.h"
#include "render/frame_graph.h"
#include "scene/render_scene.h"
#include "solver_plan.h"

namespace tyndall::participating_media {

/// So many media are rendered at once, with so many blobs in all; what is beyond is left out, with a warning.
inline constexpr size_t kMaximumMedia = 16;
inline constexpr size_t kMaximumBlobs = 64;

/// Rays into the sky are followed to here at most, metres.
inline constexpr float kFarthest = 1e4f;

/// The uniform blocks of shaders/media.glsl. Makes its GL objects when first used.
class MediaBuffer {
 public:
    /// Uploads the scene's media when they changed. Returns those that are rendered.
    const std::vector<Medium>& update(const RenderScene& scene, const MediaSettings& settings);
    [[nodiscard]] const std::vector<Medium>& media() const { return media_; }
    [[nodiscard]] const SolverPlan& plan() const { return plan_; }
    /// Around all media, in the world.
    [[nodiscard]] const Bounds& bounds() const { return bounds_; }
    /// Light from all around; up to date when the plan has a term of it.
    [[nodiscard]] const EnvironmentLight& environment() const { return environment_; }
    /// Changes when something that is uploaded of the media does.
    [[nodiscard]] const std::string& bytes() const { return uploaded_; }
    /// No density varies.
    [[nodiscard]] bool even() const { return even_; }
    /// Sets all that media.glsl declares; `light_steps` are samples through noise and grids.
    void bind(const gpu::Program& program, int light_steps) const;
    /// Says once for each text what the module leaves out.
    void warn_once(std::string_view what);
    [[nodiscard]] const gpu::Texture& grids() const { return textures_.grids(); }
    [[nodiscard]] const gpu::Texture& phase_tables() const { return textures_.phase_tables(); }

 private:
    struct Blocks;
    void add(Blocks& blocks, const Medium& medium, const glm::mat4& box, double time_s);
    // Into the record of the medium that is being added.
    void add_density(Blocks& blocks, const DensityField& density, double time_s);
    void add_blobs(Blocks& blocks, const BlobDensity& field);
    [[nodiscard]] glm::vec4 grid_size(const GridDensity& grid) const;
    gpu::Buffer buffer_, blobs_;
    MediaTextures textures_;
    std::vector<Medium> media_;
    SolverPlan plan_;
    EnvironmentLight environment_;
    Bounds bounds_;
    bool even_ = true;
    std::string uploaded_;  ///< the buffers' bytes
    std::set<std::string, std::less<>> warned_;
};

/// Brings the buffer up to date before any pass of the frame looks at media.
class UploadPass final : public Pass {
 public:
    /// `settings` must outlive the pass.
    UploadPass(std::shared_ptr<MediaBuffer> media, const MediaSettings& settings)
        : media_(std::move(media)), settings_(settings) {}
    [[nodiscard]] std::string_view name() const override { return "participating_media.upload"; }
    void declare(PassDeclaration& declaration) override;
    void execute(PassContext& context) override;

 private:
    std::shared_ptr<MediaBuffer> media_;
    const MediaSettings& settings_;
};

}  // namespace tyndall::participating_media
