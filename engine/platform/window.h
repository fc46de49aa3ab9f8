#pragma once
/// A window with an OpenGL 4.5 core context, and the events that arrive in it.

#include <glm/vec2.hpp>
#include <memory>
#include <string>

#include "platform/context.h"
#include "platform/input.h"

struct GLFWwindow;

namespace tyndall::platform {

struct WindowDesc {
    std::string title = "Tyndall";
    glm::ivec2 size{1280, 720};  ///< of the content, before the monitor's scale
    bool fullscreen = false;
    bool vsync = true;
    bool visible = true;
    ContextOptions context;
};

/// One window. Its functions belong on the main thread, as the window systems demand.
class Window final : public Context {
 public:
    /// Throws Error when there is no display (go headless then) or its driver lacks OpenGL 4.5.
    explicit Window(const WindowDesc& desc);
    ~Window() override;

    void make_current() override;
    /// Starts a frame of input and handles what has arrived since the last one.
    void poll();
    [[nodiscard]] const InputState& input() const;

    /// The user closed it, or request_close() was called.
    [[nodiscard]] bool close_requested() const;
    void request_close();
    void set_title(const std::string& title);

    /// In pixels; (0, 0) while minimised: draw nothing then.
    [[nodiscard]] glm::ivec2 framebuffer_size() const;
    /// In the window system's own units, which may be larger than pixels.
    [[nodiscard]] glm::ivec2 size() const;
    /// How much larger text and controls should be than on a plain monitor.
    [[nodiscard]] float content_scale() const;
    void resize(glm::ivec2 size);

    [[nodiscard]] bool fullscreen() const;
    /// Fills the monitor that shows most of the window, in its present mode; or goes back to where the window was.
    void set_fullscreen(bool fullscreen);
    /// Waits for the monitor in swap(), or does not.
    void set_vsync(bool vsync);
    /// Hides and holds the pointer, so that the mouse turns the view without end.
    void capture_mouse(bool captured);
    [[nodiscard]] bool mouse_captured() const;
    [[nodiscard]] bool focused() const;

    /// Copies a flat texture with display-encoded colours into the window, as large as fits with its proportions, and
    /// binds the window for drawing on top (overlays).
    void blit(unsigned int texture, glm::ivec2 texture_size);
    /// Shows what was drawn.
    void swap();

    /// For libraries that attach themselves to a GLFW window.
    [[nodiscard]] GLFWwindow* native() const;

 private:
    struct Implementation;
    std::unique_ptr<Implementation> self_;
};

}  // namespace tyndall::platform
