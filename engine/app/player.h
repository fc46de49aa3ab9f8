#pragma once
/// A scene in a window: the frame loop of `tyndall play` and of the game.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/camera_control.h"
#include "app/engine.h"
#include "app/module_builder.h"
#include "app/overlay.h"
#include "platform/bindings.h"
#include "platform/window.h"

namespace tyndall {

struct PlayerOptions {
    std::filesystem::path scene;
    Assignments changes;
    std::filesystem::path ocio;
    std::string camera;
    std::string view;  ///< a target shown in place of the picture
    glm::ivec2 size{1280, 720};
    float render_scale = 1.0f;  ///< of the window's pixels
    bool fullscreen = false;
    bool vsync = true;
    bool watch = false;                ///< rebuild and reload what is saved
    int frames = 0;                    ///< quit after so many; 0 = when the user does
    std::filesystem::path screenshot;  ///< written when it quits
};

/// Runs a scene until the user leaves.
class Player {
 public:
    /// Throws Error when there is no window or the scene cannot be loaded.
    explicit Player(const PlayerOptions& options);
    ~Player();
    void run();

 private:
    void frame(double seconds);
    void handle_actions();
    void look_through(size_t viewpoint);
    void move_camera(float seconds);
    void next_target();
    void collect_colliders();
    void watch();
    [[nodiscard]] CameraWish wish(float seconds) const;
    [[nodiscard]] OverlayText overlay_text(double seconds) const;
    [[nodiscard]] std::string help() const;
    void save_screenshot(const std::filesystem::path& file) const;
    [[nodiscard]] bool pressed(std::string_view action) const { return bindings_.pressed(window_.input(), action); }

    PlayerOptions options_;
    platform::Window window_;
    platform::Bindings bindings_;
    Engine engine_;
    Overlay overlay_;
    std::optional<ModuleBuilder> builder_;
    Walker walker_;
    CameraControl control_;
    std::vector<std::string> viewpoints_;  ///< cameras, then camera paths
    size_t viewpoint_ = 0;
    std::optional<double> path_time_s_;  ///< while a camera path is followed
    float exposure_steps_ = 0.0f;        ///< stops added by the user
    size_t target_ = 0;                  ///< 0 = the picture, else a target of Renderer::views
    uint64_t colliders_version_ = 0;
    bool show_help_ = false, show_statistics_ = false, paused_ = false, screenshot_due_ = false;
};

}  // namespace tyndall
