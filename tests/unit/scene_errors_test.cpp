#include <gtest/gtest.h>

#include "scene/problems.h"
#include "scene_test_types.h"

namespace tyndall::scene_test {
namespace {

TEST(SceneErrors, TheSampleHasNone) {
    EXPECT_EQ(problems_of(kSample), "");
}

TEST(SceneErrors, AllOfAFileAtOnceWithPlaceAndNearestName) {
    EXPECT_EQ(problems_of("{ \"tyndall\": 1, \"modulse\": [],\n"
                          "  \"render\": { \"path\": \"defered\", \"marhc\": {} },\n"
                          "  \"entities\": [ { \"fogg\": {} } ] }"),
              "test.json:1:17: /modulse: unknown key 'modulse' (expected '$schema', 'description', 'tyndall', "
              "'modules', 'render' or 'entities'; did you mean 'modules'?)\n"
              "test.json:2:23: /render/path: unknown path 'defered' (expected 'deferred' or 'light_pre_pass'; did you "
              "mean 'deferred'?)");
    EXPECT_EQ(
        problems_of(scene_with("\"fogg\": {}, \"fog\": { \"density\": 11, \"qualty\": 1, \"quality\": \"hig\" }")),
        "test.json:3:7: /entities/0/fogg: unknown component 'fogg' (expected a component, \"name\" or \"parent\"; "
        "did you mean 'fog'?)\n"
        "test.json:3:39: /entities/0/fog/density: 11 is out of range (expected 0 to 10)\n"
        "test.json:3:43: /entities/0/fog/qualty: unknown field 'qualty' (expected 'scattering_per_m', 'density', "
        "'quality', 'phase', 'shadow', 'texture', 'points', 'weights', 'tags', 'size' or 'turn'; did you mean "
        "'quality'?)\n"
        "test.json:3:67: /entities/0/fog/quality: unknown value 'hig' (expected 'low' or 'high'; did you mean "
        "'high'?)");
}

struct Case {
    const char* fog;
    const char* message;
};
class WrongField : public testing::TestWithParam<Case> {};

TEST_P(WrongField, IsNamed) {
    const std::string text = problems_of(scene_with("\"fog\": { " + std::string(GetParam().fog) + " }"));
    EXPECT_NE(text.find(GetParam().message), std::string::npos) << text;
    EXPECT_NE(text.find("test.json:3:"), std::string::npos) << text;
}
INSTANTIATE_TEST_SUITE_P(
    Fields, WrongField,
    testing::Values(
        Case{"\"density\": \"1\"", "/fog/density: is a string (expected a number)"},
        Case{"\"density\": 1e300", "/fog/density: 1e300 is too large"},
        Case{"\"scattering_per_m\": [1, 2]", "has 2 values (expected an array of 3 numbers)"},
        Case{"\"scattering_per_m\": 1", "is a number (expected an array of 3 numbers)"},
        Case{"\"scattering_per_m\": [1, -2, 3]",
             "/fog/scattering_per_m/1: -2 1/m is out of range (expected 0 to 1000 1/m)"},
        Case{"\"size\": [1]", "has 1 value (expected an array of 2 numbers)"},
        Case{"\"turn\": [0, 0, 0, 0]", "is no rotation"},
        Case{"\"quality\": 1", "is a number (expected 'low' or 'high')"},
        Case{"\"shadow\": { \"size\": 1.5 }", "/fog/shadow/size: 1.5 is not whole"},
        Case{"\"shadow\": { \"size\": 1e10 }", "/fog/shadow/size: 1e10 is out of range (expected 16 to 8192)"},
        Case{"\"shadow\": { \"enabled\": 1 }", "is a number (expected true or false)"},
        Case{"\"shadow\": []", "is an array (expected an object)"},
        Case{"\"texture\": null", "is null (expected a string)"},
        Case{"\"phase\": {}", "has 0 keys (expected an object with exactly one key: 'isotropic' or 'forward')"},
        Case{"\"phase\": { \"isotropic\": {}, \"forward\": {} }", "has 2 keys"},
        Case{"\"phase\": { \"forwrad\": {} }", "unknown choice 'forwrad'"},
        Case{"\"phase\": { \"forward\": { \"g\": 1 } }", "/fog/phase/forward/g: 1 is out of range"},
        Case{"\"points\": [ {}, { \"positon\": [0, 0, 0] } ]", "/fog/points/1/positon: unknown field"},
        Case{"\"weights\": [0, \"a\"]", "/fog/weights/1: is a string"},
        Case{"\"tags\": {}", "is an object (expected an array)"},
        Case{"\"density\": 1, \"density\": 1", "key 'density' is there twice"},
        Case{"\"preset\": \"dust\"", "unknown preset 'dust'"}));

TEST(SceneErrors, Structure) {
    const auto has = [](std::string_view scene, std::string_view message) {
        const std::string text = problems_of(scene);
        EXPECT_NE(text.find(message), std::string::npos) << text;
    };
    has("[]", "is an array (expected an object: a scene)");
    has("{}", "has no version (expected \"tyndall\": 1)");
    has("{ \"tyndall\": 2 }", "is of another version");
    has("{ \"tyndall\": 1, \"entities\": {} }", "/entities: is an object (expected an array of entities)");
    has("{ \"tyndall\": 1, \"entities\": [1] }", "/entities/0: is a number");
    has("{ \"tyndall\": 1, \"modules\": [\"../x\"] }", "'../x' is no module name");
    has(scene_with("\"name\": 3"), "/entities/0/name: is a number");
    has(scene_with("\"fog\": 3"), "/entities/0/fog: is a number");
    has(scene_with("\"world_matrix\": {}"), "is made by the engine");
    has(scene_with("\"parent\": \"Dustt\" }, { \"name\": \"Dust\""),
        "no entity is named 'Dustt' (expected the name of "
        "another entity; did you mean 'Dust'?)");
    has(scene_with("\"name\": \"A\" }, { \"name\": \"A\" }, { \"parent\": \"A\""), "2 entities are named 'A'");
    has(scene_with("\"name\": \"A\", \"parent\": \"B\" }, { \"name\": \"B\", \"parent\": \"A\""), "its own ancestor");
    has(scene_with("\"name\": \"A\", \"parent\": \"A\""), "its own ancestor");
}

TEST(SceneErrors, NothingIsMadeWhenSomethingIsWrong) {
    Stage stage;
    EXPECT_THROW(stage.load(scene_with("\"name\": \"A\" }, { \"fog\": { \"density\": -1 }")), Error);
    EXPECT_EQ(stage.world.size(), 0u);
}

TEST(SceneErrors, PartsOfAbsentModulesAreNone) {
    const std::string members = "\"medium\": { \"x\": 1 }";
    EXPECT_NE(problems_of(scene_with(members)), "");
    std::string text = scene_with(members);
    text.insert(1, " \"modules\": [\"participating_media\"], \"render\": { \"media\": {} },");
    EXPECT_EQ(problems_of(text), "");
}

TEST(SceneErrors, AreCounted) {
    std::string many = "\"fog\": { \"weights\": [2";
    for (int i = 0; i < 5000; ++i) many += ", 2";
    Stage stage;
    try {
        stage.load(scene_with(many + "] }"));
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.diagnostics().size(), Problems::kMaximum);
    }
}

}  // namespace
}  // namespace tyndall::scene_test
