// Changing the world while walking over it.
#include <gtest/gtest.h>

#include <array>
#include <stdexcept>
#include <thread>
#include <utility>
#include <vector>

#include "ecs_test_types.h"

namespace tyndall {
namespace {

using EcsIteration = EcsTest;

TEST_F(EcsIteration, TheStateBeforeIsSeenUntilTheEnd) {
    const Entity a = world.create_with(Position{1, 0, 0});
    const Entity b = world.create_with(Position{2, 0, 0});
    Entity made;
    int visited = 0;
    world.each<Position>([&](Entity entity, Position&) {
        ++visited;
        if (entity != a) return;
        made = world.create_with(Position{3, 0, 0}, Label{"made"});
        EXPECT_TRUE(world.alive(made));
        EXPECT_EQ(world.find<Position>(made), nullptr);
        world.set_name(made, "made");
        EXPECT_EQ(world.find_named("made"), made);
        world.remove<Position>(b);
        world.add(a, Label{"a"});
        world.destroy(a);
        EXPECT_NE(world.find<Position>(b), nullptr);
        EXPECT_EQ(world.find<Label>(a), nullptr);
        EXPECT_TRUE(world.alive(a));
    });
    EXPECT_EQ(visited, 2);
    EXPECT_FALSE(world.alive(a));
    EXPECT_EQ(world.find<Position>(b), nullptr);
    EXPECT_EQ(world.find<Position>(made)->x, 3);
    EXPECT_EQ(world.find<Label>(made)->text, "made");
    EXPECT_EQ(world.size(), 2u);
}

TEST_F(EcsIteration, RecordedChangesHappenInOrder) {
    const Entity entity = world.create_with(Position{});
    world.each<Position>([&](Entity, Position&) {
        world.add(entity, Label{"first"});
        world.remove<Label>(entity);
    });
    EXPECT_EQ(world.find<Label>(entity), nullptr);
    world.each<Position>([&](Entity, Position&) {
        world.add(entity, Label{"first"});
        world.remove<Label>(entity);
        world.add(entity, Label{"a text that is too long for the small string buffer"});
        EXPECT_EQ(world.add(entity, registry.find<Wide>()), nullptr);
    });
    EXPECT_EQ(world.find<Label>(entity)->text.size(), 51u);
    EXPECT_EQ(world.find<Wide>(entity)->value, 0u);
    world.each<Position>([&](Entity, Position&) {
        world.destroy(entity);
        world.destroy(entity);
        world.add(entity, Counted());
        EXPECT_EQ(Counted::living, 1);
    });
    EXPECT_FALSE(world.alive(entity));
    EXPECT_EQ(Counted::living, 0);
}

TEST_F(EcsIteration, ThoseMadeAndDestroyedAtOnceLeaveNothing) {
    world.create_with(Position{});
    world.each<Position>([&](Entity entity, Position&) {
        const Entity parent = world.create_with(Counted());
        const Entity child = world.create_with(Counted());
        EXPECT_TRUE(world.set_parent(child, parent));
        world.destroy(parent);
        world.destroy(child);
        world.destroy(entity);
    });
    EXPECT_EQ(Counted::living, 0);
    EXPECT_EQ(world.size(), 0u);
}

TEST_F(EcsIteration, NestedWalksChangeNothingUntilTheOutermostEnds) {
    for (int i = 0; i < 100; ++i) world.create_with(Position{float(i), 0, 0});
    size_t visits = 0;
    world.each<Position>([&](Entity outer, Position& p) {
        const World& unchanging = world;
        unchanging.each<Position>([&](Entity inner, const Position& q) {
            ++visits;
            if (outer == inner) world.create_with(Position{p.x + q.x, 0, 0});
        });
        if (int(p.x) % 2 == 0) world.destroy(outer);
        EXPECT_TRUE(world.alive(outer));
    });
    EXPECT_EQ(visits, 100u * 100u);
    EXPECT_EQ(world.size(), 150u);
}

TEST_F(EcsIteration, AThrowingCallbackEndsTheWalkAndKeepsTheWorldWhole) {
    const Entity entity = world.create_with(Position{});
    Entity made;
    const auto walk = [&] {
        world.each<Position>([&](Entity, Position&) {
            world.each<Position>([&](Entity, Position&) {
                made = world.create_with(Counted());
                throw std::runtime_error("enough");
            });
        });
    };
    EXPECT_THROW(walk(), std::runtime_error);
    EXPECT_NE(world.find<Counted>(made), nullptr);
    world.add(entity, Label{"at once"});  // not recorded: nothing is iterating any more
    EXPECT_EQ(world.find<Label>(entity)->text, "at once");
    world.destroy(made);
    EXPECT_EQ(Counted::living, 0);
}

TEST_F(EcsIteration, ManyLargeValuesWaitUnharmed) {
    std::vector<Entity> entities;
    for (int i = 0; i < 5000; ++i) entities.push_back(world.create_with(Position{float(i), 0, 0}));
    for (int round = 0; round < 2; ++round) {
        world.each<Position>([&](Entity entity, Position& p) {
            world.add(entity, Wide{uint64_t(p.x)});
            world.add(entity, Label{std::string(40, char('a' + int(p.x) % 26))});
            world.add(entity, Counted());
        });
        for (size_t i = 0; i < entities.size(); ++i) {
            ASSERT_EQ(world.find<Wide>(entities[i])->value, i);
            ASSERT_EQ(world.find<Label>(entities[i])->text, std::string(40, char('a' + int(i) % 26)));
        }
        ASSERT_EQ(Counted::living, 5000);
    }
    world.each(
        registry.find<Counted>(), [](void* w, Entity entity, void*) { static_cast<World*>(w)->destroy(entity); },
        &world);
    EXPECT_EQ(Counted::living, 0);
    EXPECT_EQ(world.size(), 0u);
}

TEST_F(EcsIteration, ThreadsReadSideBySide) {
    for (int i = 0; i < 1000; ++i) world.create_with(Position{float(i), 0, 0});
    std::array<float, 4> sums{};
    std::vector<std::thread> threads;
    for (float& sum : sums)
        threads.emplace_back([&world = std::as_const(world), &sum] {
            for (int round = 0; round < 20; ++round)
                world.each<Position>([&](Entity e, const Position&) { sum += world.find<Position>(e)->x; });
        });
    for (std::thread& thread : threads) thread.join();
    for (const float sum : sums) EXPECT_EQ(sum, 20 * 499500.0f);
}

TEST_F(EcsIteration, AFailedDefaultLeavesTheEntityAsItWas) {
    const Entity entity = world.create_with(Label{"here"}, Counted());
    Fragile::broken = true;
    EXPECT_THROW(world.add(entity, registry.find<Fragile>()), int);
    Fragile::broken = false;
    EXPECT_EQ(world.find<Fragile>(entity), nullptr);
    EXPECT_EQ(world.find<Label>(entity)->text, "here");
    EXPECT_NE(world.add(entity, registry.find<Fragile>()), nullptr);
    world.destroy(entity);
    EXPECT_EQ(Counted::living, 0);
}

}  // namespace
}  // namespace tyndall
