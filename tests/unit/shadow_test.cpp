#include <gmock/gmock.h>

#include <random>

#include "light_fixture.h"

namespace tyndall {
namespace {

const glm::vec3 kUp(0.0f, 1.0f, 0.0f);
const glm::vec3 kInVolume(0.0f);

using ShadowTest = LightTest;

TEST_F(ShadowTest, SpotShadowsWhatStandsBehind) {
    add(plane(20.0f));
    add_box({0.0f, 2.0f, 0.0f}, {1.0f, 0.2f, 1.0f});
    add_light(LightKind::spot, {0.0f, 6.0f, 0.0f}, {0.0f, 0.0f, 0.0f});
    render();
    EXPECT_EQ(lit({0.0f, 0.0f, 0.0f}, kUp), 0.0f);
    EXPECT_EQ(lit({0.0f, 1.0f, 0.0f}, kInVolume), 0.0f);
    EXPECT_EQ(lit({2.0f, 0.0f, 0.0f}, kUp), 1.0f);
    EXPECT_EQ(lit({0.0f, 3.0f, 0.0f}, kInVolume), 1.0f);
    EXPECT_EQ(lit({0.0f, 2.1f, 0.0f}, kUp), 1.0f) << "the occluder's own lit side";
}

TEST_F(ShadowTest, PointShadowsInAllDirections) {
    const glm::vec3 directions[] = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    for (const glm::vec3& direction : directions) {
        scene_.surfaces.clear();
        scene_.lights.clear();
        add_box(5.0f * direction, {1.0f, 1.0f, 1.0f});
        add_light(LightKind::point, {0.0f, 0.0f, 0.0f}, {1.0f, 1.0f, 0.0f}, 512);
        render();
        for (const glm::vec3& other : directions)
            EXPECT_EQ(lit(8.0f * other, kInVolume), other == direction ? 0.0f : 1.0f);
        EXPECT_EQ(lit(4.5f * direction, -direction), 1.0f);
    }
}

TEST_F(ShadowTest, PointHasNoSeamsBetweenFaces) {
    add_box({0.0f, 0.0f, 0.0f}, {9.0f, 7.0f, 11.0f});
    add_light(LightKind::point, {1.0f, -0.5f, 0.7f}, {0.0f, 0.0f, 0.0f}, 512);
    render();
    std::mt19937 random(3);
    std::uniform_real_distribution<float> uniform(-1.0f, 1.0f);
    std::vector<ProbePoint> points;
    for (int i = 0; i < 6000; ++i) {  // on the walls of the room, from inside
        glm::vec3 at(uniform(random), uniform(random), uniform(random));
        const int axis = i % 3;
        at[axis] = at[axis] < 0.0f ? -1.0f : 1.0f;
        glm::vec3 normal(0.0f);
        normal[axis] = -at[axis];
        const glm::vec3 inside =
            glm::clamp(at, -0.97f, 0.97f);  // not so near to the corners that the filter sees the next wall
        at = glm::mix(inside, at, glm::abs(normal));
        points.push_back({glm::vec4(at * glm::vec3(4.5f, 3.5f, 5.5f), 0.0f), glm::vec4(normal, 0.0f)});
    }
    const std::vector<ProbeResult> results = probe(points);
    for (size_t i = 0; i < points.size(); ++i)
        EXPECT_GT(results[i].transmittance.x, 0.99f)
            << points[i].position.x << ' ' << points[i].position.y << ' ' << points[i].position.z;
}

TEST_F(ShadowTest, DirectionalShadowsInALargeScene) {
    add(plane(200.0f));
    add_box({0.0f, 1.0f, 0.0f}, {1.0f, 2.0f, 1.0f});
    add_box({0.0f, 60.0f, -90.0f}, {6.0f, 1.0f, 6.0f});  // above and outside of what the camera sees
    add_light(LightKind::directional, {5.0f, 5.0f, 0.0f}, {0.0f, 0.0f, 0.0f}).shadow.distance_m = 150.0f;
    render();
    EXPECT_GT(shadow_maps_->plan().views.size(), 1u);
    EXPECT_EQ(lit({-1.2f, 0.0f, 0.0f}, kUp), 0.0f);
    EXPECT_EQ(lit({-1.0f, 0.8f, 0.0f}, kInVolume), 0.0f);
    EXPECT_EQ(lit({1.2f, 0.0f, 0.0f}, kUp), 1.0f);
    EXPECT_EQ(lit({-60.0f, 0.0f, -90.0f}, kUp), 0.0f) << "the plate high above";
    EXPECT_EQ(lit({0.0f, 0.0f, -90.0f}, kUp), 1.0f);
    EXPECT_EQ(lit({-60.0f, 0.0f, -190.0f}, kUp), 1.0f) << "beyond the cascades";
    EXPECT_EQ(lit({0.0f, 500.0f, 0.0f}, kInVolume), 1.0f) << "above the scene";
}

TEST_F(ShadowTest, NoAcneOnAPlaneAtAnyAngle) {
    add(plane(10.0f));
    std::mt19937 random(5);
    std::uniform_real_distribution<float> uniform(-9.0f, 9.0f);
    std::vector<ProbePoint> points;
    for (int i = 0; i < 4000; ++i)
        points.push_back({{uniform(random), 0.0f, uniform(random), 0.0f}, glm::vec4(kUp, 0.0f)});
    for (const LightKind kind : {LightKind::directional, LightKind::spot, LightKind::point})
        for (const float degrees : {90.0f, 60.0f, 30.0f, 10.0f, 5.0f, 2.0f})
            for (const float turn : {0.0f, 0.6f}) {
                scene_.lights.clear();
                const float elevation = glm::radians(degrees);
                const glm::vec3 from(12.0f * std::cos(elevation) * std::cos(turn), 12.0f * std::sin(elevation),
                                     12.0f * std::cos(elevation) * std::sin(turn));
                add_light(kind, from, {0.0f, 0.0f, 0.0f}).outer_angle = 1.2f;
                render();
                float least = 1.0f;
                for (const ProbeResult& result : probe(points)) least = std::min(least, result.transmittance.x);
                EXPECT_GT(least, 0.99f) << "kind " << static_cast<int>(kind) << ", elevation " << degrees << ", turn "
                                        << turn;
            }
}

TEST_F(ShadowTest, ShadowsBeginAtTheContact) {
    add(plane(10.0f));
    add_box({0.0f, 1.0f, 0.0f}, {0.3f, 2.0f, 6.0f});  // a wall across the light
    for (const float degrees : {30.0f, 45.0f, 60.0f}) {
        scene_.lights.clear();
        const float elevation = glm::radians(degrees);
        add_light(LightKind::directional, {std::cos(elevation), std::sin(elevation), 0.0f}, {0.0f, 0.0f, 0.0f});
        render();
        ASSERT_EQ(shadow_maps_->plan().views.back().fades, false);
        const float texel = shadow_maps_->plan().views.back().texel_m;
        EXPECT_LT(lit({-0.15f - 2.0f * texel, 0.0f, 0.1f}, kUp), 0.05f) << degrees;
        EXPECT_LT(lit({-0.15f - 0.1f * texel, 0.0f, 0.1f}, kUp), 0.05f) << degrees;
        EXPECT_GT(lit({0.15f + 2.0f * texel, 0.0f, 0.1f}, kUp), 0.95f) << degrees;
        EXPECT_GT(lit({0.15f, 2.0f * texel, 0.1f}, {1.0f, 0.0f, 0.0f}), 0.95f) << degrees;
    }
}

TEST_F(ShadowTest, SurfacesWithoutBackFacesCastFromBehind) {
    add(plane(10.0f));
    add(quads({{glm::vec3(-1, 2, 1), glm::vec3(0, 0, -2), glm::vec3(2, 0, 0)}}));  // faces down, away from the light
    add_light(LightKind::directional, {0.0f, 10.0f, 0.0f}, {0.0f, 0.0f, 0.0f});
    render();
    EXPECT_EQ(lit({0.0f, 0.0f, 0.0f}, kUp), 0.0f);
}

TEST_F(ShadowTest, OnlyWhatChangedIsDrawnAgain) {
    add(plane(5.0f));
    add_box({-3.0f, 0.5f, 0.0f}, glm::vec3(0.5f));
    add_box({3.0f, 0.5f, 0.0f}, glm::vec3(0.5f));
    add_light(LightKind::spot, {-3.0f, 4.0f, 0.0f}, {-3.0f, 0.0f, 0.0f}, 256).outer_angle = 0.3f;
    add_light(LightKind::spot, {3.0f, 4.0f, 0.0f}, {3.0f, 0.0f, 0.0f}, 256).outer_angle = 0.3f;
    add_light(LightKind::directional, {1.0f, 4.0f, 0.0f}, {0.0f, 0.0f, 0.0f}, 256);
    render();
    EXPECT_EQ(shadow_maps_->rendered(), static_cast<int>(shadow_maps_->plan().views.size()));
    render();
    EXPECT_EQ(shadow_maps_->rendered(), 0);
    look_from({0.01f, 1.7f, 10.0f}, {0.01f, 1.0f, 0.0f});
    render();
    EXPECT_EQ(shadow_maps_->rendered(), 0) << "a small step of the camera";
    EXPECT_EQ(lit({3.4f, 0.0f, 0.0f}, kUp, 1), 1.0f);
    move(scene_.surfaces[2], {0.4f, 0.0f, 0.0f});
    render();
    EXPECT_EQ(shadow_maps_->rendered(), static_cast<int>(shadow_maps_->plan().views.size()) - 1)
        << "all but the first spot";
    EXPECT_EQ(lit({3.4f, 0.0f, 0.0f}, kUp, 1), 0.0f);
    EXPECT_EQ(lit({-3.0f, 0.0f, 0.0f}, kUp, 0), 0.0f) << "the first spot's map is still there";
}

TEST_F(ShadowTest, LightsWithoutShadowsAndEmptyScenes) {
    add_light(LightKind::directional, {0.0f, 1.0f, 0.0f}, {0.0f, 0.0f, 0.0f});
    render();
    EXPECT_EQ(lit({0.0f, 0.0f, 0.0f}, kUp), 1.0f);
    add(plane(5.0f));
    scene_.lights[0].shadow.enabled = false;
    render();
    EXPECT_EQ(lit({0.0f, -1.0f, 0.0f}, kUp), 1.0f);
    scene_.lights.clear();
    render();
}

}  // namespace
}  // namespace tyndall
