// The entity world: handles, components, names, views, the registry.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>

#include "core/error.h"
#include "ecs_test_types.h"

namespace tyndall {
namespace {

using Ecs = EcsTest;

TEST_F(Ecs, HandlesOfTheDestroyedStayDead) {
    const Entity first = world.create();
    EXPECT_TRUE(world.alive(first));
    world.destroy(first);
    world.destroy(first);
    EXPECT_FALSE(world.alive(first));
    const Entity second = world.create_with(Position{1, 2, 3});
    EXPECT_EQ(second.index, first.index);
    EXPECT_NE(second, first);
    EXPECT_FALSE(world.alive(first));
    EXPECT_EQ(world.find<Position>(first), nullptr);
    world.add(first, Position{});
    world.remove<Position>(first);
    world.destroy(first);
    EXPECT_TRUE(world.alive(second));
    EXPECT_EQ(world.find<Position>(second)->y, 2);
    EXPECT_FALSE(world.alive(Entity{}));
    EXPECT_FALSE(world.alive(Entity{1000, 0}));
    EXPECT_EQ(world.size(), 1u);
    EXPECT_EQ(world.entities(), std::vector<Entity>{second});
}

TEST_F(Ecs, AddReplacesAndRemoveForgets) {
    const Entity entity = world.create();
    EXPECT_EQ(world.find<Label>(entity), nullptr);
    world.add(entity, Label{"one"});
    world.add(entity, Position{1, 2, 3});
    world.add(entity, Label{"two"});
    EXPECT_EQ(world.find<Label>(entity)->text, "two");
    EXPECT_EQ(world.find<Position>(entity)->z, 3);
    world.remove<Label>(entity);
    world.remove<Label>(entity);
    EXPECT_EQ(world.find<Label>(entity), nullptr);
    EXPECT_EQ(world.find<Position>(entity)->z, 3);
}

TEST_F(Ecs, ComponentsByIdAreDefaultOrMoved) {
    const ComponentId label = registry.find<Label>();
    const Entity entity = world.create();
    EXPECT_EQ(static_cast<Label*>(world.add(entity, label))->text, "default");
    Label other{"a text that is too long for the small string buffer"};
    EXPECT_EQ(static_cast<Label*>(world.add(entity, label, &other))->text.substr(0, 6), "a text");
    EXPECT_TRUE(other.text.empty());
    world.add<Position>(entity);
    EXPECT_EQ(world.components(entity), (std::vector{registry.find<Position>(), label}));
    EXPECT_EQ(static_cast<const World&>(world).find(entity, label), world.find<Label>(entity));
    EXPECT_THROW(world.add(entity, ComponentId::none), Error);
    EXPECT_EQ(world.find(entity, ComponentId::none), nullptr);
}

TEST_F(Ecs, UnregisteredTypesAreRefusedOrAbsent) {
    const Entity entity = world.create();
    EXPECT_THROW(world.add(entity, Unregistered{}), Error);
    EXPECT_THROW(world.create_with(Position{}, Unregistered{}), Error);
    EXPECT_EQ(world.size(), 1u);
    EXPECT_EQ(world.find<Unregistered>(entity), nullptr);
    world.remove<Unregistered>(entity);
    world.each<Unregistered>([](Entity, Unregistered&) { FAIL(); });
}

TEST_F(Ecs, ViewsVisitExactlyThoseThatHaveAll) {
    const Entity both = world.create_with(Position{1, 0, 0}, Label{"both"});
    const Entity position = world.create_with(Position{2, 0, 0});
    const Entity label = world.create_with(Label{"label"});
    const Entity nothing = world.create();
    const auto visited = [&]<class... C>(const World& of) {
        std::vector<Entity> seen;
        of.each<C...>([&](Entity entity, const C&...) { seen.push_back(entity); });
        std::sort(seen.begin(), seen.end(), [](Entity a, Entity b) { return a.index < b.index; });
        return seen;
    };
    EXPECT_EQ((visited.operator()<Position, Label>(world)), std::vector{both});
    EXPECT_EQ((visited.operator()<Position>(world)), (std::vector{both, position}));
    EXPECT_EQ((visited.operator()<Label>(world)), (std::vector{both, label}));
    EXPECT_EQ((visited.operator()<>(world)), (std::vector{both, position, label, nothing}));

    world.each<Position, const Label>([](Entity, Position& p, const Label& l) { p.y = float(l.text.size()); });
    EXPECT_EQ(world.find<Position>(both)->y, 4);
    EXPECT_EQ(world.find<Position>(position)->y, 0);
    float sum = 0;
    const auto add_up = [](void* total, Entity, void* p) {
        *static_cast<float*>(total) += static_cast<Position*>(p)->x;
    };
    world.each(registry.find<Position>(), add_up, &sum);
    EXPECT_EQ(sum, 3);
}

TEST_F(Ecs, NamesAreFoundAndLeaveWithTheirEntity) {
    const Entity a = world.create(), b = world.create(), c = world.create();
    world.set_name(b, "column");
    world.set_name(a, "column");
    world.set_name(c, "altar");
    EXPECT_EQ(world.find_named("column"), a);
    EXPECT_EQ(world.name(c), "altar");
    world.destroy(a);
    EXPECT_EQ(world.find_named("column"), b);
    world.set_name(b, "pew");
    EXPECT_FALSE(world.find_named("column"));
    EXPECT_EQ(world.find_named("pew"), b);
    world.set_name(b, "");
    EXPECT_FALSE(world.find_named("pew"));
    EXPECT_FALSE(world.find_named(""));
    const Entity again = world.create();
    EXPECT_EQ(world.name(again), "");
    EXPECT_EQ(world.name(a), "");
    world.set_name(a, "dead");
    EXPECT_FALSE(world.find_named("dead"));
}

TEST_F(Ecs, VersionGrowsWithStructureOnly) {
    uint64_t last = world.version();
    const auto grew = [&] { return std::exchange(last, world.version()) < last; };
    const Entity entity = world.create();
    EXPECT_TRUE(grew());
    world.add(entity, Position{});
    EXPECT_TRUE(grew());
    world.find<Position>(entity)->x = 1;
    world.each<Position>([](Entity, Position& p) { p.x = 2; });
    EXPECT_FALSE(grew());
    world.set_parent(entity, world.create());
    EXPECT_TRUE(grew());
    world.remove<Position>(entity);
    EXPECT_TRUE(grew());
    world.destroy(entity);
    EXPECT_TRUE(grew());
}

/// A hundred thousand random changes, against a model that cannot be wrong.
TEST_F(Ecs, AgreesWithAMapOfMaps) {
    struct Model {
        std::map<uint32_t, float> position;
        std::map<uint32_t, std::string> label;
        std::map<uint32_t, uint64_t> wide;
        std::map<uint32_t, Entity> alive;
    } model;
    std::mt19937 random(7);
    const auto check = [&](Entity e) {
        const auto same = [&](const auto* found, const auto& expected, auto value_of) {
            const auto place = expected.find(e.index);
            ASSERT_EQ(found != nullptr, place != expected.end());
            if (found) {
                ASSERT_EQ(value_of(*found), place->second);
            }
        };
        same(world.find<Position>(e), model.position, [](const Position& p) { return p.x; });
        same(world.find<Label>(e), model.label, [](const Label& l) { return l.text; });
        same(world.find<Wide>(e), model.wide, [](const Wide& w) { return w.value; });
    };
    for (int step = 0; step < 100'000; ++step) {
        const auto dice = static_cast<uint32_t>(random());
        if (model.alive.empty() || (dice % 16 == 0 && model.alive.size() < 500)) {
            const Entity e =
                dice & 256 ? world.create() : world.create_with(Label{std::to_string(step)}, Position{float(step)});
            model.alive[e.index] = e;
            if (dice & 256) continue;
            model.label[e.index] = std::to_string(step);
            model.position[e.index] = float(step);
            continue;
        }
        const Entity e = std::next(model.alive.begin(), long((dice >> 8) % model.alive.size()))->second;
        switch (dice % 16) {
            case 1:
                world.destroy(e);
                ASSERT_FALSE(world.alive(e));
                model.alive.erase(e.index), model.position.erase(e.index), model.label.erase(e.index),
                    model.wide.erase(e.index);
                break;
            case 2:
            case 3:
            case 4:
                world.add(e, Position{float(step)}), model.position[e.index] = float(step);
                break;
            case 5:
            case 6:
            case 7:
                world.add(e, Label{std::to_string(step)}), model.label[e.index] = std::to_string(step);
                break;
            case 8:
            case 9:
                world.add(e, Wide{uint64_t(step)}), model.wide[e.index] = uint64_t(step);
                break;
            case 10:
            case 11:
                world.remove<Position>(e), model.position.erase(e.index);
                break;
            case 12:
            case 13:
                world.remove<Label>(e), model.label.erase(e.index);
                break;
            default:
                world.remove<Wide>(e), model.wide.erase(e.index);
        }
        if (world.alive(e)) check(e);
        if (HasFatalFailure()) return;
        if (step % 5000 != 0) continue;
        for (const auto& [index, entity] : model.alive) check(entity);
        size_t labels = 0;
        world.each<Label>([&](Entity entity, const Label& l) { labels += model.label.at(entity.index) == l.text; });
        ASSERT_EQ(labels, model.label.size());
        ASSERT_EQ(world.size(), model.alive.size());
    }
    world.each<Wide>([](Entity, Wide& w) { EXPECT_EQ(reinterpret_cast<uintptr_t>(&w) % alignof(Wide), 0u); });
}

TEST_F(Ecs, EveryValueIsDestroyedOnce) {
    {
        World own(registry);
        std::vector<Entity> entities;
        for (int i = 0; i < 1000; ++i) entities.push_back(own.create_with(Counted(), Position{}));
        for (int i = 0; i < 1000; i += 2) own.add(entities[size_t(i)], Label{std::string(100, 'x')});
        for (int i = 0; i < 1000; i += 3) own.destroy(entities[size_t(i)]);
        for (int i = 1; i < 1000; i += 3) own.remove<Counted>(entities[size_t(i)]);
        EXPECT_EQ(Counted::living, 333);
    }
    EXPECT_EQ(Counted::living, 0);
}

TEST_F(Ecs, DroppedComponentsAreDestroyedAndTheirIdIsFree) {
    const Entity a = world.create_with(Counted(), Position{1, 2, 3});
    const Entity b = world.create_with(Counted());
    world.create_with(Position{4, 5, 6}, Label{"kept"}, Counted());
    const ComponentId id = registry.find<Counted>();
    world.drop_components(id);
    EXPECT_EQ(Counted::living, 0);
    EXPECT_EQ(world.size(), 3u);
    EXPECT_EQ(world.find<Counted>(a), nullptr);
    EXPECT_EQ(world.find<Position>(a)->z, 3);
    registry.remove(id);
    EXPECT_EQ(registry.find("counted"), ComponentId::none);
    EXPECT_THROW((void)registry.type(id), Error);

    // The id comes back with another type: nothing of the old one is left in its way.
    EXPECT_EQ(registry.add<Unregistered>("a module"), id);
    EXPECT_EQ(registry.owner(id), "a module");
    world.add(b, Unregistered{7});
    world.add(a, Unregistered{8});
    EXPECT_EQ(world.find<Unregistered>(b)->value, 7);
    EXPECT_EQ(world.find<Position>(a)->z, 3);
    EXPECT_EQ(registry.ids().back(), id);
    world.each<Position>([&](Entity, Position&) { EXPECT_THROW(world.drop_components(id), Error); });
}

TEST(ComponentRegistry, NamesAreUniqueAndIdsRunOut) {
    ComponentRegistry registry;
    const ComponentId position = registry.add<Position>();
    EXPECT_THROW(registry.add<Position>("a module"), Error);
    EXPECT_EQ(registry.find("position"), position);
    EXPECT_EQ(registry.find("positiom"), ComponentId::none);
    EXPECT_EQ(registry.find(""), ComponentId::none);
    EXPECT_THROW(registry.remove(ComponentId::none), Error);
    const auto numbered = [](size_t i) {
        auto type = std::make_shared<StructType>(*describe_struct<Position>({}));
        type->name = "type_" + std::to_string(i);
        return type;
    };
    for (size_t i = 1; i < ComponentRegistry::kMaximumTypes; ++i) registry.add(numbered(i), "test");
    EXPECT_THROW(registry.add(numbered(1000), "test"), Error);
    for (size_t i = 1; i < ComponentRegistry::kMaximumTypes; ++i)
        EXPECT_EQ(registry.type(registry.find("type_" + std::to_string(i))).name, "type_" + std::to_string(i));
    registry.remove(registry.find("type_99"));
    EXPECT_EQ(registry.find("type_99"), ComponentId::none);
    EXPECT_NE(registry.find("type_100"), ComponentId::none);
    EXPECT_EQ(registry.names().size(), 255u);
    registry.remove(position);
    EXPECT_EQ(registry.find<Position>(), ComponentId::none);
    registry.add<Position>();
    EXPECT_EQ(registry.names().back(), "position");
}

}  // namespace
}  // namespace tyndall
