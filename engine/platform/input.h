#pragma once
/// What keyboard, mouse and gamepad do in a frame. Independent of windows: a Window feeds it, and so can a replay.

#include <array>
#include <bitset>
#include <glm/vec2.hpp>
#include <span>
#include <string>
#include <string_view>

namespace tyndall::platform {

/// A key, a mouse button, a gamepad button or one direction of a gamepad stick. Keys have GLFW's numbers.
enum class Control : int { none = -1 };
inline constexpr int kMouseButtons = 352;    ///< the first of 8
inline constexpr int kGamepadButtons = 360;  ///< the first of 15
inline constexpr int kSticks = 376;    ///< the first of 8: left, right, up, down of the left stick, then the right
inline constexpr int kTriggers = 384;  ///< left, right
inline constexpr int kControls = 386;

/// A control and what it is called in config/input.json ("Left Shift", "Mouse Right", "Pad Left Stick Up").
struct NamedControl {
    std::string name;
    Control control = Control::none;
};
/// All that have a name, each once.
[[nodiscard]] std::span<const NamedControl> named_controls();
/// Control::none when there is none of that name.
[[nodiscard]] Control control_of(std::string_view name);
/// Empty when it has no name.
[[nodiscard]] std::string_view name_of(Control control);
/// Whether it is a direction of a stick, which rests near 0 rather than at it.
[[nodiscard]] bool is_stick(Control control);

/// What is held, and what changed since begin_frame().
class InputState {
 public:
    /// Forgets changes and motion; what is held stays held.
    void begin_frame();

    /// A control's position: 0 = at rest, 1 = fully pressed; above one half it is down. Unknown controls are ignored.
    void set(Control control, float value);
    /// The pointer, in pixels of the framebuffer from the top left.
    void set_pointer(glm::vec2 pixels) { pointer_ = pixels; }
    /// Motion of the mouse in pixels, right and down, also while the pointer is captured.
    void add_motion(glm::vec2 pixels) { motion_ += pixels; }
    /// Notches of the wheel, right and up.
    void add_scroll(glm::vec2 notches) { scroll_ += notches; }

    /// 0..1
    [[nodiscard]] float value(Control control) const;
    [[nodiscard]] bool down(Control control) const;
    /// Went down in this frame, even if it is up again.
    [[nodiscard]] bool pressed(Control control) const;
    [[nodiscard]] bool released(Control control) const;
    [[nodiscard]] glm::vec2 pointer() const { return pointer_; }
    [[nodiscard]] glm::vec2 motion() const { return motion_; }
    [[nodiscard]] glm::vec2 scroll() const { return scroll_; }

 private:
    std::array<float, kControls> values_{};
    std::bitset<kControls> pressed_;
    std::bitset<kControls> released_;
    glm::vec2 pointer_{0.0f};
    glm::vec2 motion_{0.0f};
    glm::vec2 scroll_{0.0f};
};

}  // namespace tyndall::platform
