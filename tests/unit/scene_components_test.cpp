#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "scene/components.h"
#include "scene/engine_extraction.h"
#include "scene/primitives.h"
#include "scene/scene_file.h"

namespace tyndall {
namespace {

struct EngineStage {
    ComponentRegistry registry;
    Settings settings;
    RenderOptions options;
    World world{registry};
    EngineStage() { add_engine_components(registry); }
    SceneFile load(std::string_view entity) {
        SceneFile scene =
            SceneFile::parse("{ \"tyndall\": 1, \"entities\": [\n  " + std::string(entity) + "\n] }", "t.json");
        scene.instantiate(world, settings, options);
        return scene;
    }
    std::string saved(SceneFile& scene) {
        scene.update(world, settings, options);
        const size_t begin = scene.text().find('\n') + 3;
        return scene.text().substr(begin, scene.text().rfind('\n') - begin);
    }
};

TEST(Shadows, AreOnWhereTheyAreWritten) {
    EngineStage stage;
    stage.load(
        R"({ "point_light": {} }, { "point_light": { "shadow": {} } }, { "point_light": { "shadow": { "enabled": false } } })");
    std::vector<bool> on;
    for (const Entity entity : stage.world.entities())
        on.push_back(stage.world.find<PointLightComponent>(entity)->shadow.enabled);
    EXPECT_EQ(on, (std::vector<bool>{false, true, false}));
}

TEST(Shadows, AreSavedAsTheyAre) {
    const auto after = [](std::string_view text, void (*change)(ShadowComponent&)) {
        EngineStage stage;
        SceneFile scene = stage.load(text);
        change(stage.world.find<PointLightComponent>(stage.world.entities()[0])->shadow);
        const std::string saved = stage.saved(scene);
        EngineStage again;
        again.load(saved);
        const auto& a = stage.world.find<PointLightComponent>(stage.world.entities()[0])->shadow;
        const auto& b = again.world.find<PointLightComponent>(again.world.entities()[0])->shadow;
        EXPECT_EQ(a.enabled, b.enabled);
        EXPECT_EQ(a.size, b.size);
        return saved;
    };
    EXPECT_EQ(after(R"({ "point_light": {} })", [](ShadowComponent& s) { s.enabled = true; }),
              R"({ "point_light": { "shadow": {} } })");
    EXPECT_EQ(after(R"({ "point_light": {} })", [](ShadowComponent& s) { s.size = 64; }),
              R"({ "point_light": { "shadow": { "enabled": false, "size": 64 } } })");
    EXPECT_EQ(
        after(R"({ "point_light": { "shadow": { "size": 64 } } })", [](ShadowComponent& s) { s.enabled = false; }),
        R"({ "point_light": { "shadow": { "size": 64, "enabled": false } } })");
}

TEST(Presets, FillWhatIsNotOverridden) {
    EngineStage stage;
    const std::string text = R"({ "material": { "preset": "gold", "roughness": 0.5 } })";
    SceneFile scene = stage.load(text);
    auto* material = stage.world.find<MaterialComponent>(stage.world.entities()[0]);
    EXPECT_EQ(material->metallic, 1.0f);
    EXPECT_EQ(material->roughness, 0.5f);
    EXPECT_GT(material->base_colour.x, 2.0f * material->base_colour.z);
    EXPECT_EQ(stage.saved(scene), text);
    material->ior = 2.0f;
    EXPECT_EQ(stage.saved(scene), R"({ "material": { "preset": "gold", "roughness": 0.5, "ior": 2 } })");
}

TEST(Presets, UnknownOnesAreErrors) {
    EngineStage stage;
    try {
        stage.load(
            R"({ "material": { "preset": "glod", "roughness": 0.5 } }, { "material": { "preset": "../material/gold" } },
                      { "material": { "preset": "coppr" } }, { "camera": { "preset": "x" } })");
        FAIL();
    } catch (const Error& error) {
        const std::string text = error.what();
        EXPECT_NE(text.find("/entities/0/material/preset: unknown preset 'glod'"), std::string::npos) << text;
        EXPECT_NE(text.find("unknown preset '../material/gold'"), std::string::npos) << text;
        EXPECT_NE(text.find("did you mean 'copper'?"), std::string::npos) << text;
        EXPECT_NE(text.find("camera has none"), std::string::npos) << text;
    }
}

TEST(RenderCamera, MustBeThere) {
    try {
        EngineStage stage;
        SceneFile::parse(
            R"({ "tyndall": 1, "render": { "camera": "Naves" }, "entities": [ { "name": "Nave", "camera": {} } ] })",
            "t.json")
            .instantiate(stage.world, stage.settings, stage.options);
        FAIL();
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what())
                      .find("/render/camera: no camera is named 'Naves' (expected the name of an entity "
                            "with a camera; did you mean 'Nave'?)"),
                  std::string::npos)
            << error.what();
    }
}

TEST(RenderCamera, IsNotAskedForOnceItIsGone) {
    EngineStage stage;
    SceneFile scene = stage.load(R"({ "name": "Eye", "camera": {} })");
    stage.options.camera = "Eye";
    scene.update(stage.world, stage.settings, stage.options);
    EXPECT_NE(scene.text().find("\"camera\": \"Eye\""), std::string::npos) << scene.text();
    stage.world.destroy(stage.world.find_named("Eye"));
    scene.update(stage.world, stage.settings, stage.options);
    EngineStage again;
    EXPECT_NO_THROW(SceneFile::parse(scene.text(), "t.json").instantiate(again.world, again.settings, again.options));
}

glm::vec3 position(const glm::mat4& transform) {
    return glm::vec3(transform[3]);
}

TEST(CameraPath, PassesItsPointsAtEvenSpeed) {
    const glm::vec3 far(0, 0, -100.0f);
    CameraPathComponent path{.duration_s = 10.0f,
                             .points = {{{0, 0, 0}, far}, {{1, 2, 0}, far}, {{6, 2, 3}, far}, {{7, 0, 0}, far}}};
    EXPECT_LT(glm::distance(position(camera_path_transform(path, 0.0f)), {0, 0, 0}), 1e-4f);
    EXPECT_LT(glm::distance(position(camera_path_transform(path, 10.0f)), {7, 0, 0}), 1e-4f);
    EXPECT_EQ(camera_path_transform(path, -1.0f), camera_path_transform(path, 0.0f));
    EXPECT_EQ(camera_path_transform(path, 99.0f), camera_path_transform(path, 10.0f));
    float nearest[4] = {9, 9, 9, 9};
    float least = 1e9f;
    float most = 0.0f;
    for (int i = 0; i < 1000; ++i) {
        const glm::vec3 a = position(camera_path_transform(path, 0.01f * static_cast<float>(i)));
        const glm::vec3 b = position(camera_path_transform(path, 0.01f * static_cast<float>(i + 1)));
        least = std::min(least, glm::distance(a, b));
        most = std::max(most, glm::distance(a, b));
        for (size_t p = 0; p < 4; ++p) nearest[p] = std::min(nearest[p], glm::distance(a, path.points[p].position));
    }
    EXPECT_LT(most, 1.1f * least);
    for (const float distance : nearest) EXPECT_LT(distance, 0.02f);
}

TEST(CameraPath, LoopsWithoutAJump) {
    CameraPathComponent path{
        .duration_s = 4.0f, .loop = true, .points = {{{1, 0, 0}}, {{0, 0, 1}}, {{-1, 0, 0}}, {{0, 0, -1}}}};
    for (CameraPathPoint& point : path.points) point.look_at = {0, 5, 0};
    EXPECT_LT(glm::distance(position(camera_path_transform(path, 4.0f)), position(camera_path_transform(path, 0.0f))),
              1e-4f);
    EXPECT_LT(
        glm::distance(position(camera_path_transform(path, 3.999f)), position(camera_path_transform(path, 4.001f))),
        0.01f);
    EXPECT_LT(glm::distance(position(camera_path_transform(path, 1.0f)), {0, 0, 1}), 1e-2f);
    for (float t = 0.0f; t < 4.0f; t += 0.1f)
        EXPECT_NEAR(glm::length(position(camera_path_transform(path, t))), 1.0f, 0.15f);
}

TEST(CameraPath, LooksWhereItShouldAndTurnsOnTheSpot) {
    const CameraPathComponent path{.duration_s = 2.0f, .points = {{{0, 0, 0}, {0, 0, -5}}, {{0, 0, 0}, {5, 0, 0}}}};
    const glm::mat4 middle = camera_path_transform(path, 1.0f);
    const glm::vec3 forward = -glm::vec3(middle[2]);
    EXPECT_NEAR(forward.x, std::numbers::sqrt2_v<float> / 2.0f, 0.01f);
    EXPECT_NEAR(forward.z, -std::numbers::sqrt2_v<float> / 2.0f, 0.01f);
    EXPECT_EQ(camera_path_transform({}, 1.0f), glm::mat4(1.0f));
    EXPECT_EQ(position(camera_path_transform({.points = {{{1, 2, 3}}}}, 1.0f)), glm::vec3(1, 2, 3));
}

class Primitives : public testing::TestWithParam<Primitive> {};

TEST_P(Primitives, AreClosedOrientedAndUnitSized) {
    const Mesh mesh = make_primitive(GetParam(), 48);
    EXPECT_NO_THROW(validate(mesh, "primitive"));
    const bool plane = GetParam() == Primitive::plane;
    EXPECT_NEAR(mesh.bounds.low.x, -0.5f, 2e-3f);
    EXPECT_NEAR(mesh.bounds.high.z, 0.5f, 2e-3f);
    EXPECT_NEAR(mesh.bounds.size().y, plane ? 0.0f : 1.0f, 1e-6f);
    double volume = 0.0;
    double area = 0.0;
    for (size_t i = 0; i < mesh.indices.size(); i += 3) {
        const glm::vec3& a = mesh.positions[mesh.indices[i]];
        const glm::vec3& b = mesh.positions[mesh.indices[i + 1]];
        const glm::vec3& c = mesh.positions[mesh.indices[i + 2]];
        const glm::vec3 face = glm::cross(b - a, c - a);
        ASSERT_GT(glm::length(face), 0.0f);
        for (size_t k = 0; k < 3; ++k) ASSERT_GT(glm::dot(face, mesh.normals[mesh.indices[i + k]]), 0.0f);
        volume += static_cast<double>(glm::dot(a, glm::cross(b, c))) / 6.0;
        area += 0.5 * static_cast<double>(glm::length(face));
    }
    const double pi = std::numbers::pi;
    const double volumes[] = {0, pi / 6.0, 1.0, 0.0, pi / 4.0};
    const double areas[] = {0, pi, 6.0, 1.0, 1.5 * pi};
    EXPECT_NEAR(volume, volumes[static_cast<size_t>(GetParam())], 0.01);
    EXPECT_NEAR(area, areas[static_cast<size_t>(GetParam())], 0.02);
    for (size_t i = 0; i < mesh.positions.size(); ++i) {
        EXPECT_NEAR(glm::length(mesh.normals[i]), 1.0f, 1e-5f);
        EXPECT_NEAR(glm::dot(mesh.normals[i], glm::vec3(mesh.tangents[i])), 0.0f, 1e-5f);
        EXPECT_EQ(glm::clamp(mesh.uv0[i], 0.0f, 1.0f), mesh.uv0[i]);
    }
}
INSTANTIATE_TEST_SUITE_P(Shapes, Primitives,
                         testing::Values(Primitive::sphere, Primitive::box, Primitive::plane, Primitive::cylinder));

TEST(Glob, FitsNames) {
    EXPECT_TRUE(matches_glob("glass_*", "glass_12"));
    EXPECT_TRUE(matches_glob("*", ""));
    EXPECT_TRUE(matches_glob("*a*b", "xaxbab"));
    EXPECT_TRUE(matches_glob("f?o", "foo"));
    EXPECT_FALSE(matches_glob("glass_*", "Glass_12"));
    EXPECT_FALSE(matches_glob("f?o", "fo"));
    EXPECT_FALSE(matches_glob("", "a"));
    EXPECT_FALSE(matches_glob("*********************b", std::string(5000, 'a')));
}

TEST(RigidTransform, KeepsTheDirectionAndDropsScale) {
    glm::mat4 matrix(glm::vec4(2, 0, 0, 0), glm::vec4(1, 3, 0, 0), glm::vec4(0, 1, 4, 0), glm::vec4(5, 6, 7, 1));
    const glm::mat4 rigid = rigid_transform(matrix);
    EXPECT_LT(glm::distance(glm::vec3(rigid[2]), glm::normalize(glm::vec3(0, 1, 4))), 1e-6f);
    const glm::mat3 rotation(rigid);
    const glm::mat3 unit = glm::transpose(rotation) * rotation;
    for (int i = 0; i < 3; ++i)
        for (int k = 0; k < 3; ++k) EXPECT_NEAR(unit[i][k], i == k ? 1.0f : 0.0f, 1e-6f);
    EXPECT_NEAR(glm::determinant(rotation), 1.0f, 1e-6f);
    EXPECT_EQ(position(rigid), glm::vec3(5, 6, 7));
    EXPECT_NEAR(glm::determinant(glm::mat3(rigid_transform(glm::mat4(0.0f)))), 1.0f, 1e-6f);
}

}  // namespace
}  // namespace tyndall
