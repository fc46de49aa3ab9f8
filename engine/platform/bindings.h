#pragma once
/// Which controls mean which actions: config/input.json.

#include <filesystem>
#include <functional>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "platform/input.h"

namespace tyndall::platform {

/// Something that the user can ask for.
struct ActionInfo {
    std::string name;
    std::string doc;
};
/// The actions that the program itself understands.
[[nodiscard]] std::span<const ActionInfo> engine_actions();

/// How mouse and stick turn the view.
struct LookSettings {
    float mouse_deg_per_pixel = 0.12f;
    float stick_deg_per_s = 140.0f;  ///< at full deflection
    float stick_dead_zone = 0.15f;   ///< deflection that counts as rest, 0..0.9
    bool invert_y = false;
};

/// How fast the cameras go.
struct SpeedSettings {
    float walk_m_per_s = 1.6f;
    float fly_m_per_s = 4.0f;
    float fast_factor = 3.0f;  ///< while the action "fast" is held
};

/// Controls by action. An action without controls is never active.
class Bindings {
 public:
    /// Reads a file; `more` are actions beside the engine's. Throws Error with every problem of the file.
    [[nodiscard]] static Bindings load(const std::filesystem::path& file, std::span<const ActionInfo> more = {});
    /// The same from a text; `file` is for messages.
    [[nodiscard]] static Bindings parse(std::string_view text, const std::string& file,
                                        std::span<const ActionInfo> more = {});

    /// 0..1: the strongest of the action's controls, sticks without their dead zone.
    [[nodiscard]] float value(const InputState& input, std::string_view action) const;
    [[nodiscard]] bool down(const InputState& input, std::string_view action) const;
    /// Went down in this frame.
    [[nodiscard]] bool pressed(const InputState& input, std::string_view action) const;
    [[nodiscard]] std::span<const Control> controls(std::string_view action) const;
    /// "W, Up": for help texts; empty when the action has no controls.
    [[nodiscard]] std::string describe(std::string_view action) const;

    LookSettings look;
    SpeedSettings speeds;

 private:
    std::map<std::string, std::vector<Control>, std::less<>> actions_;
};

}  // namespace tyndall::platform
