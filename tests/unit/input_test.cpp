#include <gtest/gtest.h>

#include <set>

#include "core/error.h"
#include "core/paths.h"
#include "platform/bindings.h"

namespace tyndall::platform {
namespace {

std::string error_of(const std::string& text) {
    try {
        (void)Bindings::parse(text, "input.json");
    } catch (const Error& error) {
        return error.what();
    }
    return {};
}

TEST(Controls, NamesAndNumbersAreUnique) {
    std::set<std::string> names;
    std::set<Control> controls;
    for (const NamedControl& control : named_controls()) {
        EXPECT_TRUE(names.insert(control.name).second) << control.name;
        EXPECT_TRUE(controls.insert(control.control).second) << control.name;
        EXPECT_EQ(control_of(control.name), control.control);
        EXPECT_EQ(name_of(control.control), control.name);
        EXPECT_LT(static_cast<int>(control.control), kControls);
    }
    EXPECT_EQ(control_of("Any Key"), Control::none);
    EXPECT_EQ(name_of(Control::none), "");
}

TEST(Input, ChangesLastOneFrameAndHeldKeysStay) {
    const Control w = control_of("W");
    InputState input;
    input.begin_frame();
    input.set(w, 1.0f);
    EXPECT_TRUE(input.down(w) && input.pressed(w) && !input.released(w));
    input.begin_frame();
    EXPECT_TRUE(input.down(w) && !input.pressed(w));
    input.set(w, 0.0f);
    EXPECT_TRUE(!input.down(w) && input.released(w));
    input.begin_frame();
    input.set(w, 1.0f);
    input.set(w, 0.0f);
    EXPECT_TRUE(input.pressed(w) && input.released(w) && !input.down(w)) << "a tap within one frame counts";
    input.set(Control::none, 1.0f);
    input.set(Control{kControls}, 1.0f);
    EXPECT_FALSE(input.down(Control::none) || input.down(Control{kControls}));
}

TEST(Input, MotionAddsUpWithinAFrame) {
    InputState input;
    input.add_motion({1, 2});
    input.add_motion({3, 4});
    input.add_scroll({0, 1});
    input.set_pointer({10, 20});
    EXPECT_EQ(input.motion(), glm::vec2(4, 6));
    EXPECT_EQ(input.scroll(), glm::vec2(0, 1));
    input.begin_frame();
    EXPECT_EQ(input.motion(), glm::vec2(0.0f));
    EXPECT_EQ(input.scroll(), glm::vec2(0.0f));
    EXPECT_EQ(input.pointer(), glm::vec2(10, 20));
}

TEST(BindingsTest, ThePhysicalControlsOfAnActionAddUpToTheStrongest) {
    const Bindings bindings = Bindings::parse(
        R"({"look": {"stick_dead_zone": 0.2}, "actions": {"move_forward": ["W", "Pad Left Stick Up"], "quit": []}})",
        "f");
    InputState input;
    input.set(control_of("Pad Left Stick Up"), 0.2f);
    EXPECT_EQ(bindings.value(input, "move_forward"), 0.0f) << "a stick at rest";
    input.set(control_of("Pad Left Stick Up"), 0.6f);
    EXPECT_FLOAT_EQ(bindings.value(input, "move_forward"), 0.5f);
    input.set(control_of("W"), 1.0f);
    EXPECT_EQ(bindings.value(input, "move_forward"), 1.0f);
    EXPECT_TRUE(bindings.down(input, "move_forward") && bindings.pressed(input, "move_forward"));
    EXPECT_FALSE(bindings.down(input, "quit") || bindings.down(input, "reload"));
    EXPECT_EQ(bindings.describe("move_forward"), "W, Pad Left Stick Up");
}

TEST(BindingsTest, TheProjectsOwnFileBindsEveryAction) {
    const Bindings bindings = Bindings::load(paths::root() / "config" / "input.json");
    for (const ActionInfo& action : engine_actions())
        EXPECT_NE(bindings.describe(action.name), "") << action.name << " (" << action.doc << ")";
    EXPECT_EQ(bindings.describe("quit"), "Escape");
    EXPECT_GT(bindings.speeds.walk_m_per_s, 0.0f);
}

TEST(BindingsTest, EveryProblemIsSaidAtOnceWithTheNearestName) {
    const std::string message = error_of(R"({
        "tyndall_input": 2, "acions": {},
        "look": {"mouse_deg_per_pixel": -1, "invert_y": 3, "invert": true},
        "speeds": {"walk_m_per_s": "fast"},
        "actions": {"move_forwrd": ["W"], "quit": ["Escpe", 7], "jump": "Space"}})");
    for (const char* expected :
         {"/tyndall_input: unknown version '2'", "did you mean 'actions'", "/look/mouse_deg_per_pixel: '-1' is out",
          "/look/invert_y: '3'", "unknown look setting 'invert'", "/speeds/walk_m_per_s: '\"fast\"'",
          "/actions/move_forwrd: unknown action", "did you mean 'move_forward'", "/actions/quit/0: unknown control",
          "did you mean 'Escape'", "/actions/quit/1: unknown control '7'", "/actions/jump: not a list"})
        EXPECT_NE(message.find(expected), std::string::npos) << expected << " in\n" << message;
}

TEST(BindingsTest, BrokenJsonSaysWhere) {
    EXPECT_NE(error_of("{\n  \"actions\": oops }").find("input.json:2:14:"), std::string::npos)
        << error_of("{\n  \"actions\": oops }");
    for (const char* text : {"", "[]", "3", "{\"actions\": 3}", "{\"look\": []}", "\"\\ud800\"", "{\"a\":"})
        EXPECT_NE(error_of(text), "") << text;
}

TEST(BindingsTest, OthersBringTheirOwnActions) {
    const std::vector<ActionInfo> more{{"open_door", "opens the door ahead"}};
    const Bindings bindings = Bindings::parse(R"({"actions": {"open_door": ["F"]}})", "f", more);
    EXPECT_EQ(bindings.describe("open_door"), "F");
}

}  // namespace
}  // namespace tyndall::platform
