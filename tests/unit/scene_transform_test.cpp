#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

#include "scene/component_form.h"
#include "scene_test_types.h"

namespace tyndall::scene_test {
namespace {

glm::vec3 world_forward(const World& world, Entity entity) {
    const glm::mat4 matrix = parent_matrix(world, entity) * world.find<Transform>(entity)->matrix();
    return glm::normalize(glm::vec3(matrix * glm::vec4(0.0f, 0.0f, -1.0f, 0.0f)));
}

glm::vec3 world_position(const World& world, Entity entity) {
    return parent_matrix(world, entity) * glm::vec4(world.find<Transform>(entity)->translation, 1.0f);
}

void expect_near(const glm::vec3& a, const glm::vec3& b, float tolerance = 1e-5f) {
    EXPECT_LT(glm::length(a - b), tolerance)
        << a.x << ' ' << a.y << ' ' << a.z << " is not " << b.x << ' ' << b.y << ' ' << b.z;
}

TEST(LookAt, FacesThePointUpright) {
    const glm::quat rotation = look_at_rotation(glm::mat4(1.0f), {1, 2, 3}, {4, 6, 3});
    expect_near(rotation * glm::vec3(0, 0, -1), glm::normalize(glm::vec3(3, 4, 0)));
    EXPECT_NEAR((rotation * glm::vec3(1, 0, 0)).y, 0.0f, 1e-6f);
    EXPECT_GT((rotation * glm::vec3(0, 1, 0)).y, 0.0f);
}

TEST(LookAt, IsDefinedStraightUpAndDownAndNowhere) {
    for (const float y : {-5.0f, 5.0f}) {
        const glm::quat rotation = look_at_rotation(glm::mat4(1.0f), {0, 0, 0}, {0, y, 0});
        expect_near(rotation * glm::vec3(0, 0, -1), glm::vec3(0, y / 5.0f, 0));
        expect_near(rotation * glm::vec3(1, 0, 0), glm::vec3(1, 0, 0));
    }
    EXPECT_EQ(look_at_rotation(glm::mat4(1.0f), {1, 1, 1}, {1, 1, 1}), glm::quat(1, 0, 0, 0));
    EXPECT_EQ(look_at_rotation(glm::mat4(0.0f), {1, 1, 1}, {1, 1, 2}), glm::quat(1, 0, 0, 0));
}

TEST(LookAt, IsAPointInTheWorldBelowAnyParent) {
    Stage stage;
    stage.load(R"({ "tyndall": 1, "entities": [
        { "name": "C", "parent": "B", "transform": { "translation": [0, 2, 1], "look_at": [10, -3, 4] } },
        { "name": "B", "parent": "A", "transform": { "translation": [1, 0, 2], "look_at": [7, 7, 7], "scale": [1, 2, 0.5] } },
        { "name": "A", "transform": { "translation": [3, 1, 0], "rotation": [0.1825742, 0.3651484, 0.5477226, 0.7302967] } } ] })");
    for (const auto& [name, target] : {std::pair("B", glm::vec3(7, 7, 7)), std::pair("C", glm::vec3(10, -3, 4))}) {
        const Entity entity = stage.named(name);
        expect_near(world_forward(stage.world, entity), glm::normalize(target - world_position(stage.world, entity)));
    }
}

constexpr std::string_view kLooking =
    R"({ "tyndall": 1, "entities": [
  { "name": "A", "transform": { "translation": [0, 1, 0] } },
  { "name": "Eye", "parent": "A", "transform": { "translation": [0, 9, -4], "look_at": [0, 0, 1] } } ] })";

TEST(LookAt, IsSavedAsWrittenUntilItIsTurned) {
    Stage stage;
    SceneFile scene = stage.load(kLooking);
    scene.update(stage.world, stage.settings, stage.options);
    EXPECT_EQ(scene.text(), kLooking);

    // Turned by hand: the rotation takes its place.
    stage.world.find<Transform>(stage.named("Eye"))->rotation = glm::quat(1, 0, 0, 0);
    scene.update(stage.world, stage.settings, stage.options);
    EXPECT_NE(scene.text().find("{ \"translation\": [0, 9, -4], \"rotation\": [0, 0, 0, 1] }"), std::string::npos)
        << scene.text();
    EXPECT_EQ(scene.text().find("look_at"), std::string::npos);
}

TEST(LookAt, MovingKeepsTheDirectionThatWasSeen) {
    Stage stage;
    SceneFile scene = stage.load(kLooking);
    stage.world.find<Transform>(stage.named("A"))->translation.x = 3.0f;
    scene.update(stage.world, stage.settings, stage.options);
    Stage again;
    again.load(scene.text());
    expect_near(world_forward(again.world, again.named("Eye")), world_forward(stage.world, stage.named("Eye")));
}

TEST(LookAt, AndRotationExcludeEachOther) {
    const std::string text =
        problems_of(scene_with(R"("transform": { "look_at": [0, 0, 0], "rotation": [0, 0, 0, 1], "scale": "big" })"));
    EXPECT_NE(text.find("look_at and rotation say the same thing"), std::string::npos) << text;
    EXPECT_NE(text.find("/transform/scale: is a string"), std::string::npos) << text;
}

}  // namespace
}  // namespace tyndall::scene_test
