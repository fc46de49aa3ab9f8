// What the entity world costs at a million entities. Each figure is "time per entity": lower is better.
#include <benchmark/benchmark.h>

#include <memory>
#include <random>

#include "ecs/transform.h"

namespace tyndall {

struct Position {
    static constexpr std::string_view kName = "position";
    float x = 0, y = 0, z = 0;
};
struct Velocity {
    static constexpr std::string_view kName = "velocity";
    float x = 1, y = 2, z = 3;
};
struct Rare {
    static constexpr std::string_view kName = "rare";
    float value = 0;
};
void describe(StructBuilder<Position>&) {}
void describe(StructBuilder<Velocity>&) {}
void describe(StructBuilder<Rare>&) {}

namespace {

constexpr size_t kCount = 1'000'000;

struct Fixture {
    Fixture() {
        registry.add<Position>();
        registry.add<Velocity>();
        registry.add<Rare>();
    }
    void fill() {
        for (size_t i = 0; i < kCount; ++i) entities.push_back(world.create_with(Position{}, Velocity{}));
    }
    ComponentRegistry registry;
    World world{registry};
    std::vector<Entity> entities;
};

void report(benchmark::State& state, size_t entities) {
    state.counters["per_entity"] = benchmark::Counter(
        static_cast<double>(entities), benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

void view_of_two(benchmark::State& state) {
    Fixture f;
    f.fill();
    for (auto _ : state) {
        f.world.each<Position, const Velocity>([](Entity, Position& p, const Velocity& v) {
            p.x += v.x * 0.01f;
            p.y += v.y * 0.01f;
            p.z += v.z * 0.01f;
        });
        benchmark::ClobberMemory();
    }
    report(state, kCount);
}
BENCHMARK(view_of_two)->Unit(benchmark::kMillisecond);

/// The floor under view_of_two: the same loop over two plain arrays.
void plain_arrays(benchmark::State& state) {
    std::vector<Position> positions(kCount);
    const std::vector<Velocity> velocities(kCount);
    for (auto _ : state) {
        for (size_t i = 0; i < kCount; ++i) {
            positions[i].x += velocities[i].x * 0.01f;
            positions[i].y += velocities[i].y * 0.01f;
            positions[i].z += velocities[i].z * 0.01f;
        }
        benchmark::ClobberMemory();
    }
    report(state, kCount);
}
BENCHMARK(plain_arrays)->Unit(benchmark::kMillisecond);

void create_with_two(benchmark::State& state) {
    for (auto _ : state) {
        state.PauseTiming();
        auto f = std::make_unique<Fixture>();
        state.ResumeTiming();
        for (size_t i = 0; i < kCount; ++i) benchmark::DoNotOptimize(f->world.create_with(Position{}, Velocity{}));
        state.PauseTiming();
        f.reset();
        state.ResumeTiming();
    }
    report(state, kCount);
}
BENCHMARK(create_with_two)->Unit(benchmark::kMillisecond);

void find_at_random(benchmark::State& state) {
    Fixture f;
    f.fill();
    std::shuffle(f.entities.begin(), f.entities.end(), std::mt19937(1));
    for (auto _ : state) {
        float sum = 0;
        for (const Entity entity : f.entities) sum += f.world.find<Velocity>(entity)->y;
        benchmark::DoNotOptimize(sum);
    }
    report(state, kCount);
}
BENCHMARK(find_at_random)->Unit(benchmark::kMillisecond);

void find_in_order(benchmark::State& state) {
    Fixture f;
    f.fill();
    for (auto _ : state) {
        float sum = 0;
        for (const Entity entity : f.entities) sum += f.world.find<Velocity>(entity)->y;
        benchmark::DoNotOptimize(sum);
    }
    report(state, kCount);
}
BENCHMARK(find_in_order)->Unit(benchmark::kMillisecond);

/// One entity in a hundred has the third component; the time is for all of the view, per entity that matches.
void view_of_one_percent(benchmark::State& state) {
    Fixture f;
    f.fill();
    size_t matching = 0;
    for (size_t i = 0; i < kCount; i += 100, ++matching) f.world.add<Rare>(f.entities[i]);
    for (auto _ : state) {
        f.world.each<Position, const Rare>([](Entity, Position& p, const Rare& rare) { p.x += rare.value; });
        benchmark::ClobberMemory();
    }
    report(state, matching);
}
BENCHMARK(view_of_one_percent)->Unit(benchmark::kMicrosecond);

void add_and_remove(benchmark::State& state) {
    Fixture f;
    f.fill();
    for (auto _ : state) {
        for (const Entity entity : f.entities) f.world.add<Rare>(entity);
        for (const Entity entity : f.entities) f.world.remove<Rare>(entity);
    }
    report(state, 2 * kCount);
}
BENCHMARK(add_and_remove)->Unit(benchmark::kMillisecond);

void destroy_all(benchmark::State& state) {
    for (auto _ : state) {
        state.PauseTiming();
        auto f = std::make_unique<Fixture>();
        f->fill();
        state.ResumeTiming();
        for (const Entity entity : f->entities) f->world.destroy(entity);
        state.PauseTiming();
        f.reset();
        state.ResumeTiming();
    }
    report(state, kCount);
}
BENCHMARK(destroy_all)->Unit(benchmark::kMillisecond);

/// A frame's work for 10 000 entities, nine in ten of them below another one.
void world_matrices(benchmark::State& state) {
    constexpr size_t kPlaced = 10'000;
    Fixture f;
    f.registry.add<Transform>();
    f.registry.add<WorldMatrix>();
    for (size_t i = 0; i < kPlaced; ++i) {
        f.entities.push_back(f.world.create_with(Transform{}));
        if (i % 10 != 0) (void)f.world.set_parent(f.entities[i], f.entities[i - (i % 10 > 3 ? 3 : 1)]);
    }
    for (auto _ : state) update_world_matrices(f.world);
    report(state, kPlaced);
}
BENCHMARK(world_matrices)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace tyndall
