#pragma once
/// Shadow maps of all lights: drawn when something in a light's view has changed, sampled by
/// render/shaders/shadow_maps.glsl.

#include <vector>

#include "gpu/gpu.h"
#include "render/frame_graph.h"
#include "render/seams.h"
#include "render/shadow_views.h"

namespace tyndall {

class GpuScene;
struct GpuLight;

/// Depth seen from each light, in the pages of one array texture (reversed-Z, 0 = nothing there).
class ShadowMaps {
 public:
    explicit ShadowMaps(const ShadowLimits& limits = {});

    /// Before the frame's passes: decides the views, makes room for them. `bounds` holds all casters and receivers.
    void prepare(const RenderScene& scene, const Bounds& bounds, glm::vec2 tan_half_fov);
    /// Draws the views whose matrix, place or casters changed since they were last drawn. GpuScene must be up to date.
    void render(GpuScene& gpu_scene);

    /// Writes a light's views to what shaders read of it.
    void describe(size_t light, GpuLight& gpu_light) const;
    /// Binds the texture "shadow_map_depths".
    void bind(const gpu::Program& program) const;
    /// Null before the first prepare.
    [[nodiscard]] const gpu::Texture* texture() const { return texture_.name() != 0 ? &texture_ : nullptr; }
    /// Views drawn by the last render.
    [[nodiscard]] int rendered() const { return rendered_; }
    [[nodiscard]] const ShadowPlan& plan() const { return plan_; }
    /// Another number each time that this view of the plan is drawn: what was made from its depths compares it.
    [[nodiscard]] uint64_t version(size_t view) const { return view < drawn_.size() ? drawn_[view].version : 0; }

 private:
    /// What a view's square holds.
    struct Drawn {
        glm::mat4 clip_from_world{0.0f};
        uint64_t casters = 0;
        int size = 0;
        int page = 0;
        glm::ivec2 corner{0};
        uint64_t version = 0;
        bool valid = false;
    };
    void make_pages();
    void draw(const ShadowView& view, GpuScene& gpu_scene) const;

    ShadowLimits limits_;
    ShadowPlan plan_;
    std::vector<Drawn> drawn_;
    gpu::Texture texture_;
    std::vector<gpu::Framebuffer> pages_;
    uint64_t version_ = 0;
    int rendered_ = 0;
    bool warned_ = false;
};

/// Draws the shadow maps; its target "shadow_maps" is what light-transmittance needs.
class ShadowPass final : public Pass {
 public:
    [[nodiscard]] std::string_view name() const override { return "shadow_maps"; }
    void declare(PassDeclaration& declaration) override;
    void execute(PassContext& context) override;

 private:
    const gpu::Texture* texture_ = nullptr;
};

/// The provider "shadow_maps" of the light-transmittance seam.
[[nodiscard]] SeamProvider shadow_map_provider();

}  // namespace tyndall
