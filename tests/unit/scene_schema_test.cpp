#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "scene/components.h"
#include "scene_test_types.h"

namespace tyndall::scene_test {
namespace {

using Json = nlohmann::json;

Json test_schema() {
    Stage stage;
    return Json::parse(scene_schema(stage.registry, stage.settings));
}

TEST(SceneSchema, SaysWhatValidationChecks) {
    const Json schema = test_schema();
    EXPECT_EQ(schema["additionalProperties"], false);
    EXPECT_EQ(schema["required"], Json::array({"tyndall"}));
    const Json& entity = schema["properties"]["entities"]["items"];
    EXPECT_EQ(entity["additionalProperties"], Json({{"type", "object"}})) << "components of absent modules";
    EXPECT_FALSE(entity["properties"].contains("world_matrix"));
    const Json& fog = entity["properties"]["fog"];
    EXPECT_EQ(fog["additionalProperties"], false);
    EXPECT_EQ(fog["description"], "A medium for tests.");
    const Json& fields = fog["properties"];
    EXPECT_EQ(fields["density"]["minimum"], 0);
    EXPECT_EQ(fields["density"]["maximum"], 10);
    EXPECT_EQ(fields["density"]["default"], 1);
    EXPECT_EQ(fields["scattering_per_m"]["minItems"], 3);
    EXPECT_EQ(fields["scattering_per_m"]["items"]["maximum"], 1000);
    EXPECT_EQ(fields["scattering_per_m"]["description"], "Scattering. Unit: 1/m. Range: 0 to 1000 1/m.");
    EXPECT_EQ(fields["quality"]["enum"], Json::array({"low", "high"}));
    EXPECT_EQ(fields["phase"]["minProperties"], 1);
    EXPECT_EQ(fields["phase"]["maxProperties"], 1);
    EXPECT_EQ(fields["phase"]["properties"]["forward"]["properties"]["g"]["maximum"], 0.99);
    EXPECT_EQ(fields["weights"]["items"]["maximum"], 1);
    EXPECT_EQ(fields["points"]["items"]["properties"]["weight"]["default"], 1);
    EXPECT_EQ(schema["properties"]["render"]["properties"]["march"]["properties"]["steps"]["default"], 32);
    EXPECT_TRUE(entity["properties"]["transform"]["properties"].contains("look_at"));
}

TEST(SceneManual, HasATableForEachComponent) {
    Stage stage;
    const std::string manual = component_manual(stage.registry, stage.settings);
    for (const char* line :
         {"### fog\n\nA medium for tests.\n", "| `density` | number | `1` |  | 0 to 10 | Multiplies it. |\n",
          "| `phase.forward.g` | number | `0` |  | -0.99 to 0.99 | Mean cosine. |\n",
          "| `shadow.size` | whole number |", "| `points[].weight` |", "### tag\n\nSays nothing.\n\nNo fields: `{}`.\n",
          "### march\n"})
        EXPECT_NE(manual.find(line), std::string::npos) << line << manual;
    EXPECT_EQ(manual.find("world_matrix"), std::string::npos);
}

TEST(ComponentJson, RoundTripsEveryKind) {
    const auto type = describe_struct<Fog>("fog");
    Fog fog;
    fog.scattering_per_m = {0.1f, 1e-9f, 999.0f};
    fog.quality = Quality::high;
    fog.phase = Forward{.g = 0.33f};
    fog.shadow = {.enabled = false, .size = 64};
    fog.texture = "\"\\\n\té";
    fog.points = {{{1, 2, 3}, 0.5f}, {}};
    fog.weights = {0.25f};
    fog.tags = {"a", ""};
    fog.turn = glm::normalize(glm::quat(1, 2, 3, 4));
    const std::string json = component_to_json(*type, &fog);
    Fog back;
    std::vector<Diagnostic> problems;
    EXPECT_EQ(component_from_json(*type, &back, json, problems), "");
    EXPECT_TRUE(problems.empty());
    EXPECT_EQ(component_to_json(*type, &back), json);
    EXPECT_EQ(back.texture, fog.texture);
    EXPECT_EQ(back.turn, fog.turn);
    EXPECT_EQ(back.points[0].position, fog.points[0].position);
}

TEST(ComponentJson, KeepsWhatItDoesNotKnowAndDefaultsWhatIsMissing) {
    const auto type = describe_struct<Fog>("fog");
    Fog fog;
    std::vector<Diagnostic> problems;
    EXPECT_EQ(component_from_json(*type, &fog,
                                  R"({ "new": [1, {}], "density": 2, "shadow": { "size": 32, "soft": 0.5 },
                                       "phase": { "forward": { "k": 1 } } })",
                                  problems),
              R"({ "new": [1, {}], "shadow": { "soft": 0.5 }, "phase": { "forward": { "k": 1 } } })");
    EXPECT_TRUE(problems.empty());
    EXPECT_EQ(fog.density, 2.0f);
    EXPECT_EQ(fog.shadow.size, 32);
    EXPECT_EQ(fog.scattering_per_m, glm::vec3(0.1f));
}

TEST(ComponentJson, SaysWhatIsWrongAndKeepsTheRest) {
    const auto type = describe_struct<Fog>("fog");
    Fog fog;
    std::vector<Diagnostic> problems;
    (void)component_from_json(*type, &fog, R"({ "density": 99, "quality": "high" })", problems);
    ASSERT_EQ(problems.size(), 1u);
    EXPECT_EQ(problems[0].where.pointer, "/density");
    EXPECT_EQ(fog.density, 1.0f);
    EXPECT_EQ(fog.quality, Quality::high);
    (void)component_from_json(*type, &fog, "{", problems);
    (void)component_from_json(*type, &fog, "[]", problems);
    EXPECT_EQ(problems.size(), 3u);
}

TEST(Settings, AreKeptByName) {
    Settings settings;
    settings.add<March>("module");
    EXPECT_THROW(settings.add<March>("other"), Error);
    settings.get<March>().steps = 5;
    EXPECT_EQ(static_cast<const March*>(settings.find("march"))->steps, 5);
    EXPECT_EQ(settings.owner("march"), "module");
    settings.reset();
    EXPECT_EQ(settings.get<March>().steps, 32);
    settings.remove("march");
    EXPECT_EQ(settings.find("march"), nullptr);
    EXPECT_TRUE(settings.names().empty());
}

}  // namespace
}  // namespace tyndall::scene_test
