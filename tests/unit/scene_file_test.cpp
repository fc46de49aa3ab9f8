#include <gtest/gtest.h>

#include "core/paths.h"
#include "scene/component_form.h"
#include "scene_test_types.h"
#include "temporary_folder.h"

namespace tyndall::scene_test {
namespace {

/// `text` with one piece exchanged; the piece must be there.
std::string exchanged(std::string_view text, std::string_view from, std::string_view to) {
    std::string out(text);
    const size_t at = out.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return out.replace(at, from.size(), to);
}

TEST(SceneFile, LoadsWhatIsWritten) {
    Stage stage;
    const SceneFile scene = stage.load(kSample);
    EXPECT_EQ(scene.modules(), std::vector<std::string>{"absent_module"});
    EXPECT_EQ(stage.options.path, "light_pre_pass");
    EXPECT_EQ(stage.options.view, "ACES 1.0 SDR");
    EXPECT_EQ(stage.settings.get<March>().steps, 48);
    ASSERT_EQ(stage.world.size(), 4u);

    const Fog& fog = *stage.world.find<Fog>(stage.named("Dust"));
    EXPECT_EQ(std::get<Forward>(fog.phase).g, 0.6f);
    EXPECT_EQ(fog.quality, Quality::high);
    ASSERT_EQ(fog.points.size(), 2u);
    EXPECT_EQ(fog.points[0].position, glm::vec3(1, 2, 3));
    EXPECT_EQ(fog.points[1].weight, 0.25f);
    EXPECT_EQ(fog.weights, (std::vector<float>{0.0f, 0.5f, 1.0f}));
    EXPECT_EQ(fog.tags[0], "é");
    EXPECT_FLOAT_EQ(fog.turn.y, 0.7071068f);
    EXPECT_EQ(fog.scattering_per_m, glm::vec3(0.1f));

    const Entity child = stage.named("Väter/x");
    EXPECT_EQ(stage.world.parent(child), stage.named("Dust"));
    EXPECT_EQ(stage.world.find<Transform>(child)->scale, glm::vec3(2.0f));
    EXPECT_EQ(stage.world.children(stage.named("Dust")).size(), 2u);
}

TEST(SceneFile, SavingAnUntouchedSceneChangesNoByte) {
    for (const std::string& text :
         {std::string(kSample), scene_with("\"fog\": {}"), std::string("{\"tyndall\":1}"),
          exchanged(kSample, "\n", "\r\n"), std::string("\xef\xbb\xbf{\"tyndall\":1,\"entities\":[{}]}\n\n")}) {
        Stage stage;
        SceneFile scene = stage.load(text);
        update_world_matrices(stage.world);
        scene.update(stage.world, stage.settings, stage.options);
        EXPECT_EQ(scene.text(), text);
    }
}

TEST(SceneFile, AChangedFieldChangesOnlyItsOwnText) {
    const auto after = [](void (*change)(Stage&)) {
        Stage stage;
        SceneFile scene = stage.load(kSample);
        change(stage);
        scene.update(stage.world, stage.settings, stage.options);
        const std::string text = scene.text();
        scene.update(stage.world, stage.settings, stage.options);
        EXPECT_EQ(scene.text(), text) << "a second save changes something";
        return text;
    };
    static const auto fog = [](Stage& s, const char* name) -> Fog& { return *s.world.find<Fog>(s.named(name)); };
    EXPECT_EQ(after([](Stage& s) { fog(s, "Nave window light").density = 2.5f; }), exchanged(kSample, "4.80", "2.5"));
    EXPECT_EQ(after([](Stage& s) { fog(s, "Nave window light").scattering_per_m.z = 0.3f; }),
              exchanged(kSample, "1e-1, 0.1]", "1e-1, 0.3]"));
    EXPECT_EQ(after([](Stage& s) { fog(s, "Nave window light").shadow.enabled = false; }),
              exchanged(kSample, "{ \"size\": 512 }", "{ \"size\": 512, \"enabled\": false }"));
    EXPECT_EQ(after([](Stage& s) { fog(s, "Nave window light").texture = "a\"b"; }),
              exchanged(kSample, "512 } }", "512 }, \"texture\": \"a\\\"b\" }"));
    EXPECT_EQ(after([](Stage& s) { std::get<Forward>(fog(s, "Dust").phase).g = -0.5f; }),
              exchanged(kSample, "0.6", "-0.5"));
    EXPECT_EQ(after([](Stage& s) { std::get<Forward>(fog(s, "Dust").phase).weight = 0.5f; }),
              exchanged(kSample, "\"g\": 0.6", "\"g\": 0.6, \"weight\": 0.5"));
    EXPECT_EQ(after([](Stage& s) { fog(s, "Dust").phase = Isotropic{}; }),
              exchanged(kSample, "{ \"forward\": { \"g\": 0.6 } }", "{ \"isotropic\": {} }"));
    EXPECT_EQ(after([](Stage& s) { fog(s, "Dust").quality = Quality::low; }),
              exchanged(kSample, "\"high\"", "\"low\""));
    EXPECT_EQ(after([](Stage& s) { fog(s, "Dust").points[1].weight = 0.75f; }), exchanged(kSample, "0.25", "0.75"));
    EXPECT_EQ(after([](Stage& s) { fog(s, "Dust").points.pop_back(); }),
              exchanged(kSample, "[ { \"position\": [1,2,3] }, { \"weight\": 0.25 } ]",
                        "[{ \"position\": [1, 2, 3], \"weight\": 1 }]"));
    EXPECT_EQ(after([](Stage& s) { s.world.find<Transform>(s.named("Väter/x"))->scale = glm::vec3(3.0f); }),
              exchanged(kSample, "\"scale\": 2", "\"scale\": 3"));
    EXPECT_EQ(after([](Stage& s) { s.world.find<Transform>(s.named("Väter/x"))->scale.y = 3.0f; }),
              exchanged(kSample, "\"scale\": 2", "\"scale\": [2, 3, 2]"));
    EXPECT_EQ(after([](Stage& s) { s.settings.get<March>().steps = 64; }), exchanged(kSample, "48", "64"));
    EXPECT_EQ(
        after([](Stage& s) { s.options.display = "sRGB"; }),
        exchanged(kSample, "\"march\": { \"steps\": 48 }", "\"march\": { \"steps\": 48 }, \"display\": \"sRGB\""));
}

TEST(SceneFile, ComponentsAndEntitiesComeAndGo) {
    Stage stage;
    SceneFile scene = stage.load(kSample);
    World& world = stage.world;
    world.remove<Fog>(stage.named("Nave window light"));
    world.add<Tag>(stage.named("Väter/x"));
    const Entity lamp = world.create();
    world.set_name(lamp, "Lamp");
    world.set_parent(lamp, stage.named("Dust"));
    world.add<Fog>(lamp, {.density = 2.0f});
    for (const Entity child :
         std::vector<Entity>(world.children(stage.named("Dust")).begin(), world.children(stage.named("Dust")).end()))
        if (world.find<Tag>(child) && world.name(child).empty()) world.destroy(child);
    world.set_name(stage.named("Väter/x"), "Son");
    scene.update(world, stage.settings, stage.options);

    std::string expected = exchanged(kSample,
                                     ",\n      \"fog\": { \"density\": 4.80, \"scattering_per_m\": [0.10, 1e-1, "
                                     "0.1], \"shadow\": { \"size\": 512 } } }",
                                     " }");
    expected = exchanged(expected, "Väter/x", "Son");
    expected = exchanged(expected, "\"scale\": 2\n      }", "\"scale\": 2\n      },\n      \"tag\": {}");
    expected = exchanged(expected, "{ \"tag\": {}, \"parent\": \"Dust\" }",
                         "{ \"name\": \"Lamp\", \"parent\": \"Dust\", \"fog\": { \"density\": 2 } }");
    EXPECT_EQ(scene.text(), expected);

    // What was saved loads as what was there.
    Stage again;
    again.load(scene.text());
    EXPECT_EQ(again.world.size(), 4u);
    EXPECT_EQ(again.world.find<Fog>(again.named("Lamp"))->density, 2.0f);
}

TEST(SceneFile, ASceneGrowsFromNothing) {
    Stage stage;
    SceneFile scene;
    const Entity a = stage.world.create();
    stage.world.set_name(a, "A");
    stage.world.add<Transform>(a, {.translation = {1.0f, 2.0f, 3.0f}});
    stage.options.view = "V";
    scene.update(stage.world, stage.settings, stage.options);
    EXPECT_EQ(
        scene.text(),
        "{\n  \"tyndall\": 1,\n  \"entities\": [{ \"name\": \"A\", \"transform\": { \"translation\": [1, 2, 3] } }],\n"
        "  \"render\": { \"view\": \"V\" }\n}\n");
    const Entity b = stage.world.create();
    stage.world.set_name(b, std::string(100, 'b'));
    scene.update(stage.world, stage.settings, stage.options);
    EXPECT_EQ(problems_of(scene.text()), "");
    stage.world.destroy(a);
    stage.world.destroy(b);
    scene.update(stage.world, stage.settings, stage.options);
    EXPECT_NE(scene.text().find("\"entities\": []"), std::string::npos) << scene.text();
}

TEST(SceneFile, LongLinesAreBroken) {
    Stage stage;
    SceneFile scene;
    for (int i = 0; i < 5; ++i) {
        const Entity entity = stage.world.create();
        stage.world.set_name(entity, "Entity number " + std::to_string(i));
        stage.world.add<Fog>(entity, {.texture = std::string(70, 't'), .tags = {std::string(60, 'a'), "b"}});
    }
    scene.update(stage.world, stage.settings, stage.options);
    EXPECT_EQ(problems_of(scene.text()), "");
    for (size_t begin = 0, end; begin < scene.text().size(); begin = end + 1) {
        end = scene.text().find('\n', begin);
        EXPECT_LE(end - begin, 120u) << scene.text().substr(begin, end - begin);
    }
}

TEST(SceneFile, ComponentsOfAbsentModulesSurvive) {
    Stage stage;
    SceneFile scene = stage.load(kSample);
    stage.world.find<Fog>(stage.named("Dust"))->quality = Quality::low;
    scene.update(stage.world, stage.settings, stage.options);
    EXPECT_NE(scene.text().find("\"absent\": { \"any\": [1, {\"thing\": null}] }"), std::string::npos);
}

struct Absent {
    static constexpr std::string_view kName = "absent";
    std::vector<float> any;
};
void describe(StructBuilder<Absent>& d) {
    d.field("any", &Absent::any, "Numbers.");
}

TEST(SceneFile, ComponentsOfALateModuleAreAdopted) {
    Stage stage;
    const std::string text = exchanged(kSample, "[1, {\"thing\": null}]", "[1, 2]");
    SceneFile scene = stage.load(text);
    stage.registry.add<Absent>("absent_module");
    scene.update(stage.world, stage.settings, stage.options);
    EXPECT_EQ(scene.text(), text) << "the world does not have it yet: that is no removal";
    scene.adopt(stage.world);
    ASSERT_NE(stage.world.find<Absent>(stage.named("Dust")), nullptr);
    stage.world.find<Absent>(stage.named("Dust"))->any[1] = 3.0f;
    scene.update(stage.world, stage.settings, stage.options);
    EXPECT_EQ(scene.text(), exchanged(text, "[1, 2]", "[1, 3]"));
    stage.world.remove<Absent>(stage.named("Dust"));
    scene.update(stage.world, stage.settings, stage.options);
    EXPECT_EQ(scene.text(), exchanged(text, ", \"absent\": { \"any\": [1, 2] }", ""));
}

TEST(SceneFile, AParentWithoutANameOfItsOwnCannotBeSaved) {
    Stage stage;
    SceneFile scene;
    const Entity parent = stage.world.create();
    const Entity child = stage.world.create();
    stage.world.set_parent(child, parent);
    EXPECT_THROW(scene.update(stage.world, stage.settings, stage.options), Error);
    stage.world.set_name(parent, "P");
    scene.update(stage.world, stage.settings, stage.options);
    EXPECT_NE(scene.text().find("{ \"parent\": \"P\" }"), std::string::npos) << scene.text();
}

class SceneFiles : public TemporaryFolder {};

TEST_F(SceneFiles, AreSavedAndLoaded) {
    Stage stage;
    stage.load(kSample).save(folder_ / "scene.json");
    EXPECT_EQ(paths::read_file(folder_ / "scene.json"), kSample);
    EXPECT_EQ(SceneFile::load(folder_ / "scene.json").text(), kSample);
    EXPECT_THROW(SceneFile::load(folder_ / "none.json"), Error);
}

TEST(SceneFile, SaysWhereAComponentIs) {
    Stage stage;
    const SceneFile scene = stage.load(kSample);
    const SourceLocation where = scene.location(stage.named("Dust"), "fog");
    EXPECT_EQ(where.file, "test.json");
    EXPECT_EQ(where.line, 8);
    EXPECT_EQ(where.column, 7);
    EXPECT_EQ(where.pointer, "/entities/1/fog");
}

std::string set_error(std::string_view pointer, std::string_view value) {
    SceneFile scene = SceneFile::parse(std::string(kSample), "test.json");
    try {
        scene.set(pointer, value);
        return {};
    } catch (const Error& error) {
        return error.what();
    }
}

TEST(SceneSet, ReplacesAndAdds) {
    const auto set = [](std::string_view pointer, std::string_view value) {
        SceneFile scene = SceneFile::parse(std::string(kSample), "test.json");
        scene.set(pointer, value);
        return scene.text();
    };
    EXPECT_EQ(set("/entities/0/fog/density", "3"), exchanged(kSample, "4.80", "3"));
    EXPECT_EQ(set("/entities/Nave window light/fog/density", "3"), exchanged(kSample, "4.80", "3"));
    EXPECT_EQ(set("/entities/Väter~1x/transform/scale", "[1, 1, 1]"),
              exchanged(kSample, "\"scale\": 2", "\"scale\": [1, 1, 1]"));
    EXPECT_EQ(set("/entities/0/fog/scattering_per_m/1", "0"), exchanged(kSample, "1e-1", "0"));
    EXPECT_EQ(set("/render/path", "deferred"), exchanged(kSample, "light_pre_pass", "deferred"));
    EXPECT_EQ(set("/render/path", "\"deferred\""), exchanged(kSample, "light_pre_pass", "deferred"));
    EXPECT_EQ(set("/render/march/quality", "high"),
              exchanged(kSample, "\"steps\": 48", "\"steps\": 48, \"quality\": \"high\""));
    EXPECT_EQ(set("/entities/3/fog/shadow/size", "64"),
              exchanged(kSample, "{ \"tag\": {}, \"parent\": \"Dust\" }",
                        "{ \"tag\": {}, \"parent\": \"Dust\", \"fog\": { \"shadow\": { \"size\": 64 } } }"));
}

TEST(SceneSet, RefusesWhatLeadsNowhere) {
    EXPECT_NE(set_error("entities", "1").find("no JSON pointer"), std::string::npos);
    EXPECT_NE(set_error("/entities/Dus/fog", "{}").find("did you mean 'Dust'?"), std::string::npos);
    EXPECT_NE(set_error("/entities/9/fog", "{}").find("0 to 3"), std::string::npos);
    EXPECT_NE(set_error("/entities/0/fog/density/x", "1").find("cannot be inside a number"), std::string::npos);
    EXPECT_NE(set_error("/render/path", "{").find("unexpected end"), std::string::npos);
    EXPECT_NE(set_error("/render/path", "forward").find("unknown path 'forward'"), std::string::npos);
    EXPECT_NE(set_error("/a~b", "1").find("~0"), std::string::npos);
}

}  // namespace
}  // namespace tyndall::scene_test
