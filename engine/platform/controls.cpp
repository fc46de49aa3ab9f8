#include <GLFW/glfw3.h>

#include <algorithm>
#include <initializer_list>
#include <utility>
#include <vector>

#include "platform/input.h"

namespace tyndall::platform {
namespace {

void add_numbered(std::vector<NamedControl>& out, const std::string& name, int first_number, int first_code,
                  int count) {
    for (int i = 0; i < count; ++i) out.push_back({name + std::to_string(first_number + i), Control{first_code + i}});
}

void add_keys(std::vector<NamedControl>& out) {
    for (char letter = 'A'; letter <= 'Z'; ++letter) out.push_back({std::string(1, letter), Control{letter}});
    add_numbered(out, "", 0, GLFW_KEY_0, 10);
    add_numbered(out, "F", 1, GLFW_KEY_F1, 25);
    add_numbered(out, "Keypad ", 0, GLFW_KEY_KP_0, 10);
    for (const auto& [name, code] :
         std::initializer_list<std::pair<const char*, int>>{{"Space", GLFW_KEY_SPACE},
                                                            {"Apostrophe", GLFW_KEY_APOSTROPHE},
                                                            {"Comma", GLFW_KEY_COMMA},
                                                            {"Minus", GLFW_KEY_MINUS},
                                                            {"Period", GLFW_KEY_PERIOD},
                                                            {"Slash", GLFW_KEY_SLASH},
                                                            {"Semicolon", GLFW_KEY_SEMICOLON},
                                                            {"Equal", GLFW_KEY_EQUAL},
                                                            {"Left Bracket", GLFW_KEY_LEFT_BRACKET},
                                                            {"Backslash", GLFW_KEY_BACKSLASH},
                                                            {"Right Bracket", GLFW_KEY_RIGHT_BRACKET},
                                                            {"Grave Accent", GLFW_KEY_GRAVE_ACCENT},
                                                            {"Escape", GLFW_KEY_ESCAPE},
                                                            {"Enter", GLFW_KEY_ENTER},
                                                            {"Tab", GLFW_KEY_TAB},
                                                            {"Backspace", GLFW_KEY_BACKSPACE},
                                                            {"Insert", GLFW_KEY_INSERT},
                                                            {"Delete", GLFW_KEY_DELETE},
                                                            {"Right", GLFW_KEY_RIGHT},
                                                            {"Left", GLFW_KEY_LEFT},
                                                            {"Down", GLFW_KEY_DOWN},
                                                            {"Up", GLFW_KEY_UP},
                                                            {"Page Up", GLFW_KEY_PAGE_UP},
                                                            {"Page Down", GLFW_KEY_PAGE_DOWN},
                                                            {"Home", GLFW_KEY_HOME},
                                                            {"End", GLFW_KEY_END},
                                                            {"Caps Lock", GLFW_KEY_CAPS_LOCK},
                                                            {"Print Screen", GLFW_KEY_PRINT_SCREEN},
                                                            {"Pause", GLFW_KEY_PAUSE},
                                                            {"Keypad Decimal", GLFW_KEY_KP_DECIMAL},
                                                            {"Keypad Divide", GLFW_KEY_KP_DIVIDE},
                                                            {"Keypad Multiply", GLFW_KEY_KP_MULTIPLY},
                                                            {"Keypad Subtract", GLFW_KEY_KP_SUBTRACT},
                                                            {"Keypad Add", GLFW_KEY_KP_ADD},
                                                            {"Keypad Enter", GLFW_KEY_KP_ENTER},
                                                            {"Left Shift", GLFW_KEY_LEFT_SHIFT},
                                                            {"Left Control", GLFW_KEY_LEFT_CONTROL},
                                                            {"Left Alt", GLFW_KEY_LEFT_ALT},
                                                            {"Left Super", GLFW_KEY_LEFT_SUPER},
                                                            {"Right Shift", GLFW_KEY_RIGHT_SHIFT},
                                                            {"Right Control", GLFW_KEY_RIGHT_CONTROL},
                                                            {"Right Alt", GLFW_KEY_RIGHT_ALT},
                                                            {"Right Super", GLFW_KEY_RIGHT_SUPER},
                                                            {"Menu", GLFW_KEY_MENU}})
        out.push_back({name, Control{code}});
}

void add_list(std::vector<NamedControl>& out, const std::string& prefix, int first,
              std::initializer_list<const char*> names) {
    for (const char* name : names) out.push_back({prefix + name, Control{first++}});
}

std::vector<NamedControl> all_controls() {
    static_assert(GLFW_KEY_LAST < kMouseButtons && GLFW_MOUSE_BUTTON_LAST < 8 && GLFW_GAMEPAD_BUTTON_LAST < 15);
    std::vector<NamedControl> out;
    add_keys(out);
    add_list(out, "Mouse ", kMouseButtons, {"Left", "Right", "Middle", "4", "5", "6", "7", "8"});
    add_list(out, "Pad ", kGamepadButtons,
             {"A", "B", "X", "Y", "Left Bumper", "Right Bumper", "Back", "Start", "Guide", "Left Thumb", "Right Thumb",
              "D-Pad Up", "D-Pad Right", "D-Pad Down", "D-Pad Left"});
    add_list(out, "Pad Left Stick ", kSticks, {"Left", "Right", "Up", "Down"});
    add_list(out, "Pad Right Stick ", kSticks + 4, {"Left", "Right", "Up", "Down"});
    add_list(out, "Pad ", kTriggers, {"Left Trigger", "Right Trigger"});
    return out;
}

}  // namespace

std::span<const NamedControl> named_controls() {
    static const std::vector<NamedControl> table = all_controls();
    return table;
}

Control control_of(std::string_view name) {
    const auto found = std::ranges::find(named_controls(), name, &NamedControl::name);
    return found == named_controls().end() ? Control::none : found->control;
}

std::string_view name_of(Control control) {
    const auto found = std::ranges::find(named_controls(), control, &NamedControl::control);
    return found == named_controls().end() ? std::string_view{} : found->name;
}

bool is_stick(Control control) {
    return static_cast<int>(control) >= kSticks && static_cast<int>(control) < kTriggers;
}

}  // namespace tyndall::platform
