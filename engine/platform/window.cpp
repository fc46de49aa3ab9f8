#include "platform/window.h"

// epoxy first: GLFW then leaves GL's own headers alone.
#include <epoxy/gl.h>

#include <GLFW/glfw3.h>

#include <algorithm>
#include <glm/common.hpp>
#include <span>

#include "core/error.h"

namespace tyndall::platform {
namespace {

std::string glfw_reason() {
    const char* text = nullptr;
    glfwGetError(&text);
    return text ? text : "no reason given";
}

/// GLFW itself, for as long as there is a window.
struct Library {
    Library() {
        glfwInitHint(GLFW_JOYSTICK_HAT_BUTTONS, GLFW_FALSE);
        if (!glfwInit())
            throw Error(Diagnostic{{},
                                   "a window cannot be opened: " + glfw_reason(),
                                   "a running display (DISPLAY or WAYLAND_DISPLAY); `tyndall capture` needs none",
                                   {}});
    }
    ~Library() { glfwTerminate(); }
    Library(const Library&) = delete;
    Library& operator=(const Library&) = delete;

    static std::shared_ptr<Library> shared() {
        static std::weak_ptr<Library> running;
        std::shared_ptr<Library> library = running.lock();
        if (!library) running = library = std::make_shared<Library>();
        return library;
    }
};

GLFWwindow* create(const WindowDesc& desc, bool core_4_5) {
    glfwDefaultWindowHints();
    if (core_4_5) {
        glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 4);
        glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 5);
        glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    }
    glfwWindowHint(GLFW_OPENGL_DEBUG_CONTEXT, desc.context.debug);
    glfwWindowHint(GLFW_DEPTH_BITS, 0);
    glfwWindowHint(GLFW_STENCIL_BITS, 0);
    glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_TRUE);
    glfwWindowHint(GLFW_AUTO_ICONIFY, GLFW_FALSE);
    glfwWindowHint(GLFW_VISIBLE, desc.visible);
    return glfwCreateWindow(std::max(desc.size.x, 1), std::max(desc.size.y, 1), desc.title.c_str(), nullptr, nullptr);
}

/// The monitor that shows most of the window; none while no monitor is there.
GLFWmonitor* monitor_of(GLFWwindow* window) {
    int x = 0, y = 0, width = 0, height = 0, count = 0;
    glfwGetWindowPos(window, &x, &y);
    glfwGetWindowSize(window, &width, &height);
    GLFWmonitor** monitors = glfwGetMonitors(&count);
    GLFWmonitor* best = glfwGetPrimaryMonitor();
    int best_area = 0;
    for (GLFWmonitor* monitor : std::span(monitors, static_cast<size_t>(count))) {
        int left = 0, top = 0;
        glfwGetMonitorPos(monitor, &left, &top);
        const GLFWvidmode* mode = glfwGetVideoMode(monitor);
        const int shown_x = std::min(x + width, left + mode->width) - std::max(x, left);
        const int shown_y = std::min(y + height, top + mode->height) - std::max(y, top);
        const int area = std::max(shown_x, 0) * std::max(shown_y, 0);
        if (area > best_area) {
            best = monitor;
            best_area = area;
        }
    }
    return best;
}

/// A stick's axis as two controls that start at `first`: negative, positive.
void set_axis(InputState& input, int first, float value) {
    input.set(Control{first}, std::max(-value, 0.0f));
    input.set(Control{first + 1}, std::max(value, 0.0f));
}

void read_gamepad(InputState& input) {
    for (int id = GLFW_JOYSTICK_1; id <= GLFW_JOYSTICK_LAST; ++id) {
        GLFWgamepadstate pad;
        if (!glfwGetGamepadState(id, &pad)) continue;
        for (int button = 0; button <= GLFW_GAMEPAD_BUTTON_LAST; ++button)
            input.set(Control{kGamepadButtons + button}, pad.buttons[button] == GLFW_PRESS ? 1.0f : 0.0f);
        set_axis(input, kSticks, pad.axes[GLFW_GAMEPAD_AXIS_LEFT_X]);
        set_axis(input, kSticks + 2, pad.axes[GLFW_GAMEPAD_AXIS_LEFT_Y]);
        set_axis(input, kSticks + 4, pad.axes[GLFW_GAMEPAD_AXIS_RIGHT_X]);
        set_axis(input, kSticks + 6, pad.axes[GLFW_GAMEPAD_AXIS_RIGHT_Y]);
        input.set(Control{kTriggers}, 0.5f + 0.5f * pad.axes[GLFW_GAMEPAD_AXIS_LEFT_TRIGGER]);
        input.set(Control{kTriggers + 1}, 0.5f + 0.5f * pad.axes[GLFW_GAMEPAD_AXIS_RIGHT_TRIGGER]);
        return;
    }
    for (int control = kGamepadButtons; control < kControls; ++control) input.set(Control{control}, 0.0f);
}

}  // namespace

struct Window::Implementation {
    std::shared_ptr<Library> library = Library::shared();
    GLFWwindow* window = nullptr;
    InputState input;
    glm::dvec2 pointer{0.0};
    bool pointer_known = false;  // false after the pointer jumped
    glm::ivec2 windowed_position{0};
    glm::ivec2 windowed_size{0};
    GLuint blit_source = 0;

    Implementation() = default;
    Implementation(const Implementation&) = delete;
    Implementation& operator=(const Implementation&) = delete;
    ~Implementation() {
        if (!window) return;
        glfwMakeContextCurrent(window);
        if (blit_source != 0) glDeleteFramebuffers(1, &blit_source);
        glfwDestroyWindow(window);
    }

    void listen();
    void pointer_moved(glm::dvec2 to);
};

void Window::Implementation::pointer_moved(glm::dvec2 to) {
    glm::ivec2 units(1), pixels(1);
    glfwGetWindowSize(window, &units.x, &units.y);
    glfwGetFramebufferSize(window, &pixels.x, &pixels.y);
    const float scale = units.x > 0 ? static_cast<float>(pixels.x) / static_cast<float>(units.x) : 1.0f;
    if (pointer_known) input.add_motion(glm::vec2(to - pointer) * scale);
    input.set_pointer(glm::vec2(to) * scale);
    pointer = to;
    pointer_known = true;
}

void Window::Implementation::listen() {
    glfwSetWindowUserPointer(window, this);
    static constexpr auto self = [](GLFWwindow* w) {
        return static_cast<Implementation*>(glfwGetWindowUserPointer(w));
    };
    glfwSetKeyCallback(window, [](GLFWwindow* w, int key, int, int action, int) {
        if (action != GLFW_REPEAT) self(w)->input.set(Control{key}, action == GLFW_PRESS ? 1.0f : 0.0f);
    });
    glfwSetMouseButtonCallback(window, [](GLFWwindow* w, int button, int action, int) {
        self(w)->input.set(Control{kMouseButtons + button}, action == GLFW_PRESS ? 1.0f : 0.0f);
    });
    glfwSetCursorPosCallback(window, [](GLFWwindow* w, double x, double y) { self(w)->pointer_moved({x, y}); });
    glfwSetCursorEnterCallback(window, [](GLFWwindow* w, int) { self(w)->pointer_known = false; });
    glfwSetScrollCallback(window, [](GLFWwindow* w, double x, double y) {
        self(w)->input.add_scroll({static_cast<float>(x), static_cast<float>(y)});
    });
}

Window::Window(const WindowDesc& desc) : self_(std::make_unique<Implementation>()) {
    self_->window = create(desc, true);
    const std::string reason = self_->window ? "" : glfw_reason();
    // Any context will do to say what the driver has instead.
    if (!self_->window) self_->window = create(desc, false);
    if (!self_->window) throw Error("a window with OpenGL 4.5 cannot be opened: " + reason);
    glfwMakeContextCurrent(self_->window);
    adopt("GLFW window", desc.context);
    self_->listen();
    set_vsync(desc.vsync);
    if (desc.fullscreen) set_fullscreen(true);
}

Window::~Window() = default;

void Window::make_current() {
    glfwMakeContextCurrent(self_->window);
}

void Window::poll() {
    self_->input.begin_frame();
    glfwPollEvents();
    read_gamepad(self_->input);
}

const InputState& Window::input() const {
    return self_->input;
}

bool Window::close_requested() const {
    return glfwWindowShouldClose(self_->window) == GLFW_TRUE;
}

void Window::request_close() {
    glfwSetWindowShouldClose(self_->window, GLFW_TRUE);
}

void Window::set_title(const std::string& title) {
    glfwSetWindowTitle(self_->window, title.c_str());
}

glm::ivec2 Window::framebuffer_size() const {
    glm::ivec2 pixels(0);
    if (!glfwGetWindowAttrib(self_->window, GLFW_ICONIFIED))
        glfwGetFramebufferSize(self_->window, &pixels.x, &pixels.y);
    return pixels;
}

glm::ivec2 Window::size() const {
    glm::ivec2 units(0);
    glfwGetWindowSize(self_->window, &units.x, &units.y);
    return units;
}

float Window::content_scale() const {
    float x = 1.0f, y = 1.0f;
    glfwGetWindowContentScale(self_->window, &x, &y);
    return std::max(x, y);
}

void Window::resize(glm::ivec2 size) {
    glfwSetWindowSize(self_->window, std::max(size.x, 1), std::max(size.y, 1));
}

bool Window::fullscreen() const {
    return glfwGetWindowMonitor(self_->window) != nullptr;
}

void Window::set_fullscreen(bool wanted) {
    Implementation& self = *self_;
    if (wanted == fullscreen()) return;
    if (!wanted) {
        glfwSetWindowMonitor(self.window, nullptr, self.windowed_position.x, self.windowed_position.y,
                             self.windowed_size.x, self.windowed_size.y, GLFW_DONT_CARE);
        return;
    }
    GLFWmonitor* monitor = monitor_of(self.window);
    if (!monitor) return;
    glfwGetWindowPos(self.window, &self.windowed_position.x, &self.windowed_position.y);
    self.windowed_size = size();
    const GLFWvidmode* mode = glfwGetVideoMode(monitor);
    glfwSetWindowMonitor(self.window, monitor, 0, 0, mode->width, mode->height, mode->refreshRate);
}

void Window::set_vsync(bool vsync) {
    glfwSwapInterval(vsync ? 1 : 0);
}

void Window::capture_mouse(bool captured) {
    if (captured == mouse_captured()) return;
    glfwSetInputMode(self_->window, GLFW_CURSOR, captured ? GLFW_CURSOR_DISABLED : GLFW_CURSOR_NORMAL);
    if (glfwRawMouseMotionSupported()) glfwSetInputMode(self_->window, GLFW_RAW_MOUSE_MOTION, captured);
    glfwGetCursorPos(self_->window, &self_->pointer.x, &self_->pointer.y);  // capturing moves it
}

bool Window::mouse_captured() const {
    return glfwGetInputMode(self_->window, GLFW_CURSOR) == GLFW_CURSOR_DISABLED;
}

bool Window::focused() const {
    return glfwGetWindowAttrib(self_->window, GLFW_FOCUSED) == GLFW_TRUE;
}

void Window::blit(unsigned int texture, glm::ivec2 from) {
    const glm::ivec2 to = framebuffer_size();
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glViewport(0, 0, to.x, to.y);
    if (from.x < 1 || from.y < 1 || to.x < 1 || to.y < 1) return;
    if (self_->blit_source == 0) glCreateFramebuffers(1, &self_->blit_source);
    glNamedFramebufferTexture(self_->blit_source, GL_COLOR_ATTACHMENT0, texture, 0);
    const glm::vec2 ratio = glm::vec2(to) / glm::vec2(from);
    const glm::ivec2 fitted(glm::round(glm::vec2(from) * std::min(ratio.x, ratio.y)));
    const glm::ivec2 low = (to - fitted) / 2;
    glDisable(GL_SCISSOR_TEST);
    if (fitted != to) {
        constexpr float kBlack[4] = {0.0f, 0.0f, 0.0f, 1.0f};
        glClearNamedFramebufferfv(0, GL_COLOR, 0, kBlack);
    }
    glBlitNamedFramebuffer(self_->blit_source, 0, 0, 0, from.x, from.y, low.x, low.y, low.x + fitted.x,
                           low.y + fitted.y, GL_COLOR_BUFFER_BIT, fitted == from ? GL_NEAREST : GL_LINEAR);
    // Left attached, the texture's memory would stay with the framebuffer after the texture is deleted.
    glNamedFramebufferTexture(self_->blit_source, GL_COLOR_ATTACHMENT0, 0, 0);
}

void Window::swap() {
    glfwSwapBuffers(self_->window);
}

GLFWwindow* Window::native() const {
    return self_->window;
}

}  // namespace tyndall::platform
