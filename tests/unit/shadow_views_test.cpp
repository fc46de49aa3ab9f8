#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>
#include <random>

#include "render/shadow_views.h"

namespace tyndall {
namespace {

const glm::vec2 kFov(0.9f, 0.5f);
const Bounds kHall{glm::vec3(-10, 0, -20), glm::vec3(10, 15, 20)};
const Bounds kLand{glm::vec3(-900, -5, -900), glm::vec3(900, 60, 900)};

Light light_of(LightKind kind, int size) {
    Light light;
    light.kind = kind;
    light.transform = glm::inverse(glm::lookAt(glm::vec3(3, 9, 2), glm::vec3(0), glm::vec3(0, 1, 0)));
    light.shadow = {.enabled = true, .size = size};
    return light;
}

RenderScene scene_of(std::vector<Light> lights) {
    RenderScene scene;
    scene.lights = std::move(lights);
    return scene;
}

glm::vec3 project(const ShadowView& view, glm::vec3 p) {
    const glm::vec4 clip = view.clip_from_world * glm::vec4(p, 1.0f);
    return glm::vec3(clip) / clip.w;
}

TEST(ShadowViews, ViewsOfEachKind) {
    Light wide = light_of(LightKind::spot, 512);
    wide.outer_angle = 1.5f;
    const ShadowPlan plan =
        plan_shadows(scene_of({light_of(LightKind::spot, 512), light_of(LightKind::point, 512), wide}), kHall, kFov);
    ASSERT_EQ(plan.views.size(), 1u + 6u + 6u);
    EXPECT_EQ(plan.views[6].light, 1u);
    EXPECT_EQ(plan.views[7].light, 2u);
}

TEST(ShadowViews, DepthIsReversed) {
    Light light = light_of(LightKind::spot, 512);
    light.range_m = 20.0f;
    const ShadowPlan plan = plan_shadows(scene_of({light}), kHall, kFov);
    const glm::vec3 from(light.transform[3]), along(-glm::vec3(light.transform[2]));
    EXPECT_GT(project(plan.views[0], from + 1.0f * along).z, project(plan.views[0], from + 5.0f * along).z);
    EXPECT_NEAR(project(plan.views[0], from + 20.0f * along).z, 0.0f, 1e-6f);
    EXPECT_NEAR(project(plan.views[0], from + 0.02f * along).z, 1.0f, 1e-3f);
}

TEST(ShadowViews, CascadesHoldTheirPartOfTheFrustum) {
    RenderScene scene = scene_of({light_of(LightKind::directional, 1024)});
    std::mt19937 random(1);
    std::uniform_real_distribution<float> uniform(-1.0f, 1.0f);
    for (int turn = 0; turn < 50; ++turn) {
        scene.camera.transform =
            glm::rotate(glm::translate(glm::mat4(1.0f), 100.0f * glm::vec3(uniform(random), 0, uniform(random))),
                        3.0f * uniform(random), glm::vec3(0, 1, 0));
        const ShadowPlan plan = plan_shadows(scene, kLand, kFov);
        ASSERT_EQ(plan.views.size(), 3u);
        for (int i = 0; i < 100; ++i) {
            const float metres = 30.0f * (1.0f + uniform(random));
            const glm::vec3 local(metres * kFov.x * uniform(random), metres * kFov.y * uniform(random), -metres);
            const glm::vec3 p(scene.camera.transform * glm::vec4(local, 1.0f));
            const glm::vec3 at = project(plan.views.back(), p);
            bool held = false;
            for (const ShadowView& view : plan.views) {
                const glm::vec3 in_view = glm::abs(project(view, p));
                held = held || (in_view.x < 1.0f && in_view.y < 1.0f);
            }
            EXPECT_TRUE(held) << at.x << " " << at.y << " at " << metres;
        }
    }
}

TEST(ShadowViews, CascadesMoveInStepsOfWholeTexels) {
    RenderScene scene = scene_of({light_of(LightKind::directional, 1024)});
    int changes = 0;
    glm::mat4 last = plan_shadows(scene, kLand, kFov).views[0].clip_from_world;
    for (int i = 1; i <= 200; ++i) {
        scene.camera.transform = glm::translate(glm::mat4(1.0f), glm::vec3(0.01f * static_cast<float>(i), 0, 0));
        const glm::mat4 now = plan_shadows(scene, kLand, kFov).views[0].clip_from_world;
        if (now == last) continue;
        ++changes;
        const glm::vec2 texels = glm::vec2(now[3] - last[3]) * 512.0f;
        EXPECT_NEAR(texels.x, std::round(texels.x), 0.01f);
        EXPECT_NEAR(texels.y, std::round(texels.y), 0.01f);
        last = now;
    }
    EXPECT_GT(changes, 0);
    EXPECT_LT(changes, 8);
}

TEST(ShadowViews, ASmallSceneNeedsOneStillCascade) {
    RenderScene scene = scene_of({light_of(LightKind::directional, 2048)});
    const ShadowPlan plan = plan_shadows(scene, {glm::vec3(-1), glm::vec3(1)}, kFov);
    ASSERT_EQ(plan.views.size(), 1u);
    EXPECT_FALSE(plan.views[0].fades);
    scene.camera.transform = glm::translate(glm::mat4(1.0f), glm::vec3(7, 2, 5));
    EXPECT_EQ(plan_shadows(scene, {glm::vec3(-1), glm::vec3(1)}, kFov).views[0].clip_from_world,
              plan.views[0].clip_from_world);
    for (int corner = 0; corner < 8; ++corner) {
        const glm::vec3 at = project(plan.views[0], {corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1});
        EXPECT_LT(std::max(std::abs(at.x), std::abs(at.y)), 1.0f);
        EXPECT_GE(at.z, 0.0f);
        EXPECT_LE(at.z, 1.0f);
    }
}

TEST(ShadowViews, SquaresNeverOverlap) {
    std::mt19937 random(9);
    for (int round = 0; round < 50; ++round) {
        std::vector<Light> lights;
        for (int i = 0; i < 1 + round % 9; ++i)
            lights.push_back(light_of(static_cast<LightKind>(random() % 3), 64 << (random() % 5)));
        const ShadowPlan plan = plan_shadows(scene_of(lights), kHall, kFov);
        for (size_t i = 0; i < plan.views.size(); ++i) {
            const ShadowView& a = plan.views[i];
            EXPECT_LT(a.page, plan.pages);
            EXPECT_LE(std::max(a.corner.x, a.corner.y) + a.size, plan.page_size);
            for (size_t j = 0; j < i; ++j) {
                const ShadowView& b = plan.views[j];
                if (a.page != b.page) continue;
                EXPECT_TRUE(a.corner.x + a.size <= b.corner.x || b.corner.x + b.size <= a.corner.x ||
                            a.corner.y + a.size <= b.corner.y || b.corner.y + b.size <= a.corner.y);
            }
        }
    }
}

TEST(ShadowViews, KeepWithinTheirLimits) {
    std::vector<Light> lights(8, light_of(LightKind::point, 2048));
    const ShadowPlan plan = plan_shadows(scene_of(lights), kHall, kFov, {.max_size = 4096, .max_bytes = 64u << 20});
    EXPECT_TRUE(plan.reduced);
    EXPECT_LE(static_cast<size_t>(plan.page_size) * static_cast<size_t>(plan.page_size) *
                  static_cast<size_t>(plan.pages) * 4u,
              64u << 20);
    EXPECT_EQ(plan.views.size(), 48u);
    EXPECT_FALSE(plan_shadows(scene_of({light_of(LightKind::spot, 700)}), kHall, kFov).reduced);
}

}  // namespace
}  // namespace tyndall
