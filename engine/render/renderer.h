#pragma once
/// From a RenderScene to pictures: either path, the modules' passes, OCIO display. Names no module.

#include <glm/vec2.hpp>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "render/frame_graph.h"
#include "render/seams.h"
#include "scene/render_scene.h"
#include "scene/settings.h"

namespace tyndall {

class ColorConfig;

/// What a frame did, for `bench` and the overlay.
struct FrameStatistics {
    std::vector<PassTime> passes;  ///< when timing is on
    size_t triangles = 0;          ///< drawn, all passes together
    size_t target_bytes = 0;       ///< frame graph
    int shadow_layers = 0;         ///< rendered anew in this frame
};

/// Owns the frame graph, the shader library, the seams, GPU copies of assets, shadow maps and the engine's own passes.
/// Made and used with the GL context current.
class Renderer {
 public:
    /// Both must outlive the renderer. Adds the engine's settings ("image", "shadows", ...) to `settings`.
    Renderer(const ColorConfig& color, Settings& settings);
    ~Renderer();
    Renderer(const Renderer&) = delete;
    Renderer& operator=(const Renderer&) = delete;

    [[nodiscard]] Seams& seams();
    [[nodiscard]] gpu::ShaderLibrary& shaders();
    [[nodiscard]] FrameGraph& graph();
    /// A module's pass; it stays the caller's and must be removed before it dies.
    void add_pass(Pass* pass);
    /// All of a module's at once: the frame is rebuilt without them before this returns.
    void remove_passes(std::span<Pass* const> passes);

    /// Names of the render paths: "deferred", "light_pre_pass".
    [[nodiscard]] static std::vector<std::string> paths();
    /// Throws Error for an unknown name, with the nearest.
    void set_path(std::string_view path);
    [[nodiscard]] std::string_view path() const;
    /// OCIO display and view; empty = the configuration's defaults. Throws Error with the nearest name; keeps the last
    /// good one.
    void set_display(const std::string& display, const std::string& view);
    /// The configuration behind ColorConfig& was reloaded.
    void color_changed();
    /// Shows a target of the frame ("gbuffer_normal", "shadow_maps") in place of the picture; empty = the picture.
    /// Throws Error with the nearest name.
    void show(std::string_view target);
    [[nodiscard]] const std::string& shown() const;
    /// Targets that can be shown in the present path.
    [[nodiscard]] std::vector<std::string> views() const;

    /// Renders into the frame's targets. A pass or program that fails is logged, the last good one is used; a frame
    /// without any is black. Never throws for what a user authored.
    void render(const RenderScene& scene, glm::ivec2 size);
    /// "radiance": scene-linear, cd/m2 per channel, before exposure. "display": encoded RGBA8. Bottom row first; null
    /// before the first frame.
    [[nodiscard]] const gpu::Texture* target(std::string_view name) const;
    /// Also keeps these to the end of the frame, for `target`.
    void retain(std::vector<std::string> targets);

    /// Rebuilds programs whose files changed. Returns how many.
    int reload_changed();
    /// Messages of broken programs and passes that run on their last good state; empty when all is well.
    [[nodiscard]] std::string problems() const;
    void set_timing(bool on);
    [[nodiscard]] FrameStatistics statistics() const;

 private:
    struct Implementation;
    std::unique_ptr<Implementation> self_;
};

}  // namespace tyndall
