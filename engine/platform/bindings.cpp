#include "platform/bindings.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "core/error.h"
#include "core/paths.h"

namespace tyndall::platform {
namespace {

using Json = nlohmann::json;

/// Collects every problem of one file.
class Reader {
 public:
    Reader(std::string file, std::vector<std::string> actions) : file_(std::move(file)), actions_(std::move(actions)) {
        for (const NamedControl& control : named_controls()) controls_.push_back(control.name);
    }

    void problem(const std::string& pointer, std::string message, std::string expected, std::string near = {}) {
        problems_.push_back({{file_, 0, 0, pointer}, std::move(message), std::move(expected), std::move(near)});
    }

    /// The members of an object that must be one of `names`.
    template <class Use>
    void each(const Json& object, const std::string& pointer, const std::vector<std::string>& names, const char* kind,
              const Use& use) {
        if (!object.is_object()) return problem(pointer, "not an object", "{ ... }");
        for (const auto& [name, value] : object.items()) {
            if (std::ranges::find(names, name) != names.end())
                use(name, value);
            else
                problem(pointer + "/" + name, fmt::format("unknown {} '{}'", kind, name), fmt::format("a {}", kind),
                        nearest_name(name, names));
        }
    }

    void number(const Json& value, const std::string& pointer, float least, float most, float& out) {
        if (!value.is_number() || value.get<double>() < least || value.get<double>() > most)
            return problem(pointer, "'" + value.dump() + "' is out of range",
                           fmt::format("a number between {} and {}", least, most));
        out = value.get<float>();
    }

    void action(const Json& list, const std::string& pointer, std::vector<Control>& out) {
        if (!list.is_array()) return problem(pointer, "not a list of controls", "such as [\"W\", \"Up\"]");
        for (size_t i = 0; i < list.size(); ++i) {
            const std::string here = pointer + "/" + std::to_string(i);
            const std::string name = list[i].is_string() ? list[i].get<std::string>() : list[i].dump();
            const Control control = list[i].is_string() ? control_of(name) : Control::none;
            if (control == Control::none)
                problem(here, "unknown control '" + name + "'", "a key, mouse button or gamepad control",
                        nearest_name(name, controls_));
            else
                out.push_back(control);
        }
    }

    void look(const Json& object, LookSettings& out) {
        const std::vector<std::string> names{"mouse_deg_per_pixel", "stick_deg_per_s", "stick_dead_zone", "invert_y"};
        each(object, "/look", names, "look setting", [&](const std::string& name, const Json& value) {
            const std::string pointer = "/look/" + name;
            if (name == "mouse_deg_per_pixel") number(value, pointer, 0.001f, 10.0f, out.mouse_deg_per_pixel);
            if (name == "stick_deg_per_s") number(value, pointer, 1.0f, 1000.0f, out.stick_deg_per_s);
            if (name == "stick_dead_zone") number(value, pointer, 0.0f, 0.9f, out.stick_dead_zone);
            if (name == "invert_y") {
                if (value.is_boolean())
                    out.invert_y = value.get<bool>();
                else
                    problem(pointer, "'" + value.dump() + "' is no truth value", "true or false");
            }
        });
    }

    void speeds(const Json& object, SpeedSettings& out) {
        each(object, "/speeds", {"walk_m_per_s", "fly_m_per_s", "fast_factor"}, "speed",
             [&](const std::string& name, const Json& value) {
                 const std::string pointer = "/speeds/" + name;
                 if (name == "walk_m_per_s") number(value, pointer, 0.01f, 100.0f, out.walk_m_per_s);
                 if (name == "fly_m_per_s") number(value, pointer, 0.01f, 1000.0f, out.fly_m_per_s);
                 if (name == "fast_factor") number(value, pointer, 1.0f, 100.0f, out.fast_factor);
             });
    }

    [[nodiscard]] const std::vector<std::string>& actions() const { return actions_; }
    void finish() {
        if (!problems_.empty()) throw Error(std::move(problems_)).within("reading input bindings");
    }

 private:
    std::string file_;
    std::vector<std::string> actions_;
    std::vector<std::string> controls_;
    std::vector<Diagnostic> problems_;
};

/// Throws Error with line and column.
Json parse_json(std::string_view text, const std::string& file) {
    try {
        return Json::parse(text);
    } catch (const Json::parse_error& error) {
        const std::string_view before = text.substr(0, std::min(error.byte > 0 ? error.byte - 1 : 0, text.size()));
        const auto line = std::ranges::count(before, '\n') + 1;
        const size_t column = before.size() - (before.rfind('\n') + 1) + 1;
        throw Error(Diagnostic{{file, static_cast<int>(line), static_cast<int>(column)},
                               "not JSON from here on",
                               "well-formed JSON",
                               {}})
            .within("reading input bindings");
    }
}

float without_dead_zone(float value, float dead_zone) {
    return std::clamp((value - dead_zone) / (1.0f - dead_zone), 0.0f, 1.0f);
}

}  // namespace

std::span<const ActionInfo> engine_actions() {
    static const std::vector<ActionInfo> actions{
        {"move_forward", "walk or fly ahead"},
        {"move_back", "walk or fly back"},
        {"move_left", "step to the left"},
        {"move_right", "step to the right"},
        {"move_up", "fly up"},
        {"move_down", "fly down"},
        {"look_left", "turn left (gamepad)"},
        {"look_right", "turn right (gamepad)"},
        {"look_up", "look up (gamepad)"},
        {"look_down", "look down (gamepad)"},
        {"look_hold", "look around with the mouse while held"},
        {"capture_mouse", "look around with the mouse until pressed again"},
        {"jump", "jump while walking"},
        {"fast", "go faster while held"},
        {"toggle_camera_mode", "walk or fly"},
        {"next_camera", "go to the scene's next camera"},
        {"previous_camera", "go to the scene's previous camera"},
        {"next_view", "show the next target of the frame"},
        {"switch_path", "change the render path"},
        {"exposure_up", "brighter by half a stop"},
        {"exposure_down", "darker by half a stop"},
        {"toggle_help", "show and hide the keys"},
        {"toggle_statistics", "show and hide the time of each pass"},
        {"pause", "stop and start the clock"},
        {"reload", "read the scene again"},
        {"fullscreen", "fill the screen, or go back to the window"},
        {"screenshot", "write the picture to a file"},
        {"quit", "leave"},
    };
    return actions;
}

Bindings Bindings::load(const std::filesystem::path& file, std::span<const ActionInfo> more) {
    return parse(paths::read_file(file), file.string(), more);
}

Bindings Bindings::parse(std::string_view text, const std::string& file, std::span<const ActionInfo> more) {
    std::vector<std::string> names;
    for (const ActionInfo& action : engine_actions()) names.push_back(action.name);
    for (const ActionInfo& action : more) names.push_back(action.name);
    const Json json = parse_json(text, file);
    Reader reader(file, names);
    Bindings out;
    reader.each(json, "", {"tyndall_input", "look", "speeds", "actions"}, "section",
                [&](const std::string& name, const Json& value) {
                    if (name == "look") reader.look(value, out.look);
                    if (name == "speeds") reader.speeds(value, out.speeds);
                    if (name == "tyndall_input" && value != 1)
                        reader.problem("/tyndall_input", "unknown version '" + value.dump() + "'", "1");
                    if (name == "actions")
                        reader.each(value, "/actions", names, "action",
                                    [&](const std::string& action, const Json& list) {
                                        reader.action(list, "/actions/" + action, out.actions_[action]);
                                    });
                });
    reader.finish();
    return out;
}

std::span<const Control> Bindings::controls(std::string_view action) const {
    const auto found = actions_.find(action);
    return found == actions_.end() ? std::span<const Control>{} : found->second;
}

float Bindings::value(const InputState& input, std::string_view action) const {
    float strongest = 0.0f;
    for (const Control control : controls(action)) {
        const float value = input.value(control);
        strongest = std::max(strongest, is_stick(control) ? without_dead_zone(value, look.stick_dead_zone) : value);
    }
    return strongest;
}

bool Bindings::down(const InputState& input, std::string_view action) const {
    return std::ranges::any_of(controls(action), [&](Control control) { return input.down(control); });
}

bool Bindings::pressed(const InputState& input, std::string_view action) const {
    return std::ranges::any_of(controls(action), [&](Control control) { return input.pressed(control); });
}

std::string Bindings::describe(std::string_view action) const {
    std::string out;
    for (const Control control : controls(action))
        out += (out.empty() ? "" : ", ") + std::string(platform::name_of(control));
    return out;
}

}  // namespace tyndall::platform
