// The hierarchy, and world matrices down it.
#include <gtest/gtest.h>

#include <algorithm>
#include <glm/gtc/matrix_transform.hpp>
#include <random>

#include "ecs/transform.h"

namespace tyndall {
namespace {

class EcsTransform : public testing::Test {
 protected:
    EcsTransform() {
        registry.add<Transform>();
        registry.add<WorldMatrix>();
    }
    Entity at(float x, Entity parent = {}) {
        const Entity entity = world.create_with(Transform{.translation = {x, 0, 0}});
        EXPECT_TRUE(world.set_parent(entity, parent));
        return entity;
    }
    float x_of(Entity entity) { return world.find<WorldMatrix>(entity)->current[3].x; }
    ComponentRegistry registry;
    World world{registry};
};

TEST_F(EcsTransform, ParentsAndChildrenAgree) {
    const Entity a = world.create(), b = world.create(), c = world.create();
    EXPECT_TRUE(world.set_parent(b, a));
    EXPECT_TRUE(world.set_parent(c, a));
    EXPECT_EQ(world.parent(b), a);
    EXPECT_TRUE(std::ranges::equal(world.children(a), std::vector{b, c}));
    EXPECT_TRUE(world.set_parent(c, b));
    EXPECT_TRUE(std::ranges::equal(world.children(a), std::vector{b}));
    EXPECT_TRUE(world.set_parent(c, {}));
    EXPECT_FALSE(world.parent(c));
    EXPECT_TRUE(world.children(b).empty());
    EXPECT_TRUE(world.set_parent(c, b));
    world.destroy(a);
    EXPECT_EQ(world.size(), 0u);
    EXPECT_FALSE(world.alive(c));
}

TEST_F(EcsTransform, CyclesAndTheDeadAreRefused) {
    const Entity a = world.create(), b = world.create(), c = world.create(), dead = world.create();
    world.destroy(dead);
    EXPECT_TRUE(world.set_parent(b, a));
    EXPECT_TRUE(world.set_parent(c, b));
    EXPECT_FALSE(world.set_parent(a, a));
    EXPECT_FALSE(world.set_parent(a, b));
    EXPECT_FALSE(world.set_parent(a, c));
    EXPECT_FALSE(world.set_parent(a, dead));
    EXPECT_FALSE(world.set_parent(dead, a));
    EXPECT_FALSE(world.parent(a));
    EXPECT_EQ(world.parent(c), b);
    world.destroy(b);  // takes c with it and leaves a
    EXPECT_EQ(world.entities(), std::vector{a});
    EXPECT_TRUE(world.children(a).empty());
    const Entity again = world.create();
    EXPECT_FALSE(world.parent(again));
}

TEST_F(EcsTransform, MatrixScalesThenRotatesThenMoves) {
    Transform t{{1, 2, 3}, glm::angleAxis(glm::radians(90.0f), glm::vec3(0, 1, 0)), {2, 3, 4}};
    const glm::mat4 expected =
        glm::translate(glm::mat4(1), t.translation) * glm::mat4_cast(t.rotation) * glm::scale(glm::mat4(1), t.scale);
    for (const float length : {1.0f, 3.0f}) {
        Transform stretched = t;
        stretched.rotation = t.rotation * length;
        for (int column = 0; column < 4; ++column)
            EXPECT_LT(glm::distance(stretched.matrix()[column], expected[column]), 1e-5f);
    }
    t.rotation = glm::quat(0, 0, 0, 0);
    EXPECT_EQ(t.matrix()[0].x, 2);
}

TEST_F(EcsTransform, MatricesFollowTheHierarchyAndRememberTheFrameBefore) {
    const Entity child = at(1), parent = at(10);
    const Entity plain = world.create();  // no Transform: identity below its parent
    ASSERT_TRUE(world.set_parent(child, parent));
    ASSERT_TRUE(world.set_parent(plain, child));
    update_world_matrices(world);
    EXPECT_EQ(x_of(child), 11);
    EXPECT_EQ(x_of(plain), 11);
    EXPECT_EQ(world.find<WorldMatrix>(child)->previous[3].x, 11);
    world.find<Transform>(parent)->translation.x = 20;
    update_world_matrices(world);
    EXPECT_EQ(x_of(plain), 21);
    EXPECT_EQ(world.find<WorldMatrix>(plain)->previous[3].x, 11);
    const Entity late = at(5, child);
    update_world_matrices(world);
    EXPECT_EQ(x_of(late), 26);
    EXPECT_EQ(world.find<WorldMatrix>(late)->previous[3].x, 26);
    EXPECT_EQ(world.find<WorldMatrix>(child)->previous[3].x, 21);
}

TEST_F(EcsTransform, AChainOfAHundredThousandTakesLinearTime) {
    constexpr size_t kDepth = 100'000;
    std::vector<Entity> chain;
    for (size_t i = 0; i < kDepth; ++i) chain.push_back(at(1));
    std::vector<size_t> order(kDepth - 1);
    for (size_t i = 0; i + 1 < kDepth; ++i) order[i] = i + 1;
    for (const size_t i : order) ASSERT_TRUE(world.set_parent(chain[i], chain[i - 1]));
    update_world_matrices(world);
    EXPECT_EQ(x_of(chain.back()), float(kDepth));
    // From the far end as well: each link is above a chain, below nothing.
    for (const size_t i : order) ASSERT_TRUE(world.set_parent(chain[i], {}));
    for (const size_t i : order) ASSERT_TRUE(world.set_parent(chain[i - 1], chain[i]));
    update_world_matrices(world);
    EXPECT_EQ(x_of(chain.front()), float(kDepth));
    EXPECT_FALSE(world.set_parent(chain.back(), chain.front()));
    world.destroy(chain.back());
    EXPECT_EQ(world.size(), 0u);
}

TEST_F(EcsTransform, RandomTreesAgreeWithMultiplyingUpwards) {
    std::mt19937 random(3);
    std::uniform_real_distribution<float> real(-1, 1);
    std::vector<Entity> entities;
    for (int i = 0; i < 500; ++i)
        entities.push_back(world.create_with(
            Transform{{real(random), real(random), real(random)},
                      glm::normalize(glm::quat(real(random), real(random), real(random), real(random))),
                      {1.0f + 0.1f * real(random), 1.0f, 1.0f}}));
    for (int i = 0; i < 2000; ++i) (void)world.set_parent(entities[random() % 500], entities[random() % 500]);
    update_world_matrices(world);
    for (const Entity entity : entities) {
        glm::mat4 expected(1);
        for (Entity e = entity; e; e = world.parent(e)) expected = world.find<Transform>(e)->matrix() * expected;
        for (int column = 0; column < 4; ++column)
            ASSERT_LT(glm::distance(world.find<WorldMatrix>(entity)->current[column], expected[column]),
                      1e-3f * (1.0f + glm::length(expected[column])));
    }
}

}  // namespace
}  // namespace tyndall
