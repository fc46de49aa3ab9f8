#pragma once
/// The engine as a program uses it: one world from one scene file, its modules, and a renderer when there is a GL
/// context.

#include <filesystem>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "color/color.h"
#include "core/file_watch.h"
#include "module/module_manager.h"
#include "render/renderer.h"
#include "scene/scene_file.h"

namespace tyndall {

/// A "/json/pointer=value" of `--set` in its two halves. Throws Error when it has no '='.
[[nodiscard]] std::pair<std::string, std::string> split_assignment(const std::string& text);

/// What to change in a scene before it is loaded.
using Assignments = std::vector<std::pair<std::string, std::string>>;

/// Where the viewer is, in place of the scene's camera.
struct View {
    glm::mat4 camera{1.0f};  ///< rigid: columns right, up, back, position
    float ev_offset = 0.0f;  ///< added to the camera's EV100
};

/// See the file's head.
class Engine {
 public:
    /// With `rendering` a GL context must be current, now and whenever the engine is used or destroyed. An empty `ocio`
    /// is $OCIO or the project's own configuration.
    explicit Engine(bool rendering, const std::filesystem::path& ocio = {});
    ~Engine();
    Engine(const Engine&) = delete;
    Engine& operator=(const Engine&) = delete;

    /// Loads the modules that the scene lists and unloads all others, checks it against all descriptions, and replaces
    /// the world. Throws Error with every problem, and then the scene before goes on.
    void load_scene(const std::filesystem::path& file, const Assignments& changes = {});
    /// The same file again with the same changes.
    void reload_scene();
    /// Takes the world's changes into the scene file's text and writes it.
    void save_scene(const std::filesystem::path& file);

    /// Advances the clock, extracts the world and renders it.
    void frame(double seconds, glm::ivec2 size, const std::optional<View>& view = std::nullopt);
    /// Extracts without rendering: for tools that only look at the scene.
    const RenderScene& extract();
    /// The next frame has no history, and the clock starts again at 0.
    void restart_clock();
    void cut() { cut_ = true; }
    /// Whether frames of volume sequences may come late (AssetStore::set_streaming): for what is played, not for
    /// pictures.
    void set_streaming(bool on) { assets_.set_streaming(on); }

    /// Reloads what changed on disk: modules, shaders, assets, the scene, the OCIO configuration. Broken ones keep
    /// their last good state. `scene` is empty until the next frame.
    void reload_changed();
    /// What is broken just now and runs on its last good state; empty when all is well.
    [[nodiscard]] std::string problems() const;

    /// The last entity of this scene that could not be made, such as one whose file is missing; empty when all were.
    [[nodiscard]] const std::string& unmade() const { return unmade_; }

    /// Entities with a camera, in the scene's order.
    [[nodiscard]] std::vector<std::string> cameras();
    /// Throws Error with the nearest name when no camera is called that. Empty = the scene's choice.
    void select_camera(const std::string& name);

    [[nodiscard]] World& world() { return world_; }
    [[nodiscard]] Settings& settings() { return settings_; }
    [[nodiscard]] RenderOptions& options() { return options_; }
    /// After `options` were changed. Throws Error for unknown names.
    void apply_options();
    [[nodiscard]] const ColorConfig& color() const { return color_; }
    [[nodiscard]] ComponentRegistry& registry() { return registry_; }
    [[nodiscard]] ModuleManager& modules() { return *modules_; }
    [[nodiscard]] Renderer& renderer() { return *renderer_; }
    [[nodiscard]] const Renderer& renderer() const { return *renderer_; }
    [[nodiscard]] const RenderScene& scene() const { return scene_; }
    [[nodiscard]] const std::filesystem::path& scene_path() const { return scene_path_; }
    [[nodiscard]] std::string scene_text() const { return scene_file_.text(); }
    /// The files that assets were read from, this scene's and those of scenes that were loaded before it.
    [[nodiscard]] std::vector<std::filesystem::path> asset_files() const { return assets_.files(); }

 private:
    void use_modules(const std::vector<std::string>& wanted);
    void replace_world(SceneFile next, const std::filesystem::path& file);
    void reload_color();
    void reload_changed_scene();

    ColorConfig color_;
    ComponentRegistry registry_;
    Extractors extractors_;
    Settings settings_;
    World world_{registry_};
    AssetStore assets_;
    std::unique_ptr<Renderer> renderer_;
    std::unique_ptr<ModuleManager> modules_;

    SceneFile scene_file_;
    std::filesystem::path scene_path_;
    FileWatch watch_;
    Assignments changes_;
    RenderOptions options_;
    std::string scene_camera_;  ///< the scene's own choice
    RenderScene scene_;
    std::string scene_problem_, color_problem_, unmade_;
    double time_s_ = 0.0;
    uint64_t frame_ = 0;
    bool cut_ = true;
};

}  // namespace tyndall
