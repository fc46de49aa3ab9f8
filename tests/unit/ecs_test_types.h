#pragma once
// Component types that the tests of the entity world share.
#include <gtest/gtest.h>

#include <string>
#include <utility>

#include "ecs/world.h"

namespace tyndall {

struct Position {
    static constexpr std::string_view kName = "position";
    float x = 0, y = 0, z = 0;
};
struct Label {
    static constexpr std::string_view kName = "label";
    std::string text = "default";
};
/// More aligned than malloc gives.
struct alignas(32) Wide {
    static constexpr std::string_view kName = "wide";
    uint64_t value = 0;
};
/// Knows how many of it live.
struct Counted {
    static constexpr std::string_view kName = "counted";
    static inline int living = 0;
    Counted() { ++living; }
    Counted(const Counted&) { ++living; }
    Counted(Counted&&) noexcept { ++living; }
    ~Counted() { --living; }
};
struct Unregistered {
    static constexpr std::string_view kName = "unregistered";
    int32_t value = 0;
};
/// Its default constructor throws when told to.
struct Fragile {
    static constexpr std::string_view kName = "fragile";
    static inline bool broken = false;
    Fragile() {
        if (broken) throw 1;
    }
};

inline void describe(StructBuilder<Position>&) {}
inline void describe(StructBuilder<Label>&) {}
inline void describe(StructBuilder<Wide>&) {}
inline void describe(StructBuilder<Counted>&) {}
inline void describe(StructBuilder<Unregistered>&) {}
inline void describe(StructBuilder<Fragile>&) {}

class EcsTest : public testing::Test {
 protected:
    EcsTest() {
        registry.add<Position>();
        registry.add<Label>();
        registry.add<Wide>();
        registry.add<Counted>();
        registry.add<Fragile>();
    }
    ComponentRegistry registry;
    World world{registry};
};

}  // namespace tyndall
