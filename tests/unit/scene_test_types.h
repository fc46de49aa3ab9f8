#pragma once
#include <gtest/gtest.h>

#include <string>
#include <variant>
#include <vector>

#include "ecs/transform.h"
#include "scene/scene_file.h"

namespace tyndall::scene_test {

/// Components with a field of every kind.
struct Isotropic {};
inline void describe(StructBuilder<Isotropic>& d) {
    d.doc("Equal in all directions.");
}
struct Forward {
    float g = 0.0f;
    float weight = 1.0f;
};
inline void describe(StructBuilder<Forward>& d) {
    d.field("g", &Forward::g, "Mean cosine.").range(-0.99, 0.99);
    d.field("weight", &Forward::weight, "Share.").range(0, 1);
}

enum class Quality { low, high };

struct Shadow {
    bool enabled = true;
    int32_t size = 1024;
};
inline void describe(StructBuilder<Shadow>& d) {
    d.field("enabled", &Shadow::enabled, "Whether there is one.");
    d.field("size", &Shadow::size, "Texels on a side.").range(16, 8192);
}

struct Point {
    glm::vec3 position{0.0f};
    float weight = 1.0f;
};
inline void describe(StructBuilder<Point>& d) {
    d.field("position", &Point::position, "Where.").unit("m");
    d.field("weight", &Point::weight, "How much.");
}

struct Fog {
    static constexpr std::string_view kName = "fog";
    glm::vec3 scattering_per_m{0.1f};
    float density = 1.0f;
    Quality quality = Quality::low;
    std::variant<Isotropic, Forward> phase;
    Shadow shadow;
    std::string texture;
    std::vector<Point> points;
    std::vector<float> weights;
    std::vector<std::string> tags;
    glm::vec2 size{1.0f};
    glm::quat turn{1.0f, 0.0f, 0.0f, 0.0f};
};
inline void describe(StructBuilder<Fog>& d) {
    d.doc("A medium for tests.");
    d.field("scattering_per_m", &Fog::scattering_per_m, "Scattering.").unit("1/m").range(0, 1000).colour();
    d.field("density", &Fog::density, "Multiplies it.").range(0, 10);
    d.field("quality", &Fog::quality, "How well.", {"low", "high"});
    d.field("phase", &Fog::phase, "Where light goes.", {"isotropic", "forward"});
    d.field("shadow", &Fog::shadow, "Its shadow.");
    d.field("texture", &Fog::texture, "Picture.").asset("texture");
    d.field("points", &Fog::points, "Places.");
    d.field("weights", &Fog::weights, "Numbers.").range(0, 1);
    d.field("tags", &Fog::tags, "Words.");
    d.field("size", &Fog::size, "Size.").unit("m");
    d.field("turn", &Fog::turn, "Rotation.");
}

struct Tag {
    static constexpr std::string_view kName = "tag";
};
inline void describe(StructBuilder<Tag>& d) {
    d.doc("Says nothing.");
}

struct March {
    static constexpr std::string_view kName = "march";
    int32_t steps = 32;
    Quality quality = Quality::low;
};
inline void describe(StructBuilder<March>& d) {
    d.doc("Settings for tests.");
    d.field("steps", &March::steps, "Steps.").range(1, 1024);
    d.field("quality", &March::quality, "How well.", {"low", "high"});
}

/// A scene that uses everything, written as a person would.
inline constexpr std::string_view kSample = R"({ "tyndall": 1,
  "modules": ["absent_module"],
  "render":  { "path": "light_pre_pass", "view": "ACES 1.0 SDR", "march": { "steps": 48 } },
  "entities": [
    { "name": "Nave window light", "transform": { "translation": [0, 9, -4], "look_at": [0, 0, 1] },
      "fog": { "density": 4.80, "scattering_per_m": [0.10, 1e-1, 0.1], "shadow": { "size": 512 } } },
    { "name": "Dust", "transform": { "scale": [6, 10, 14] }, "absent": { "any": [1, {"thing": null}] },
      "fog": { "phase": { "forward": { "g": 0.6 } }, "quality": "high", "turn": [0, 0.7071068, 0, 0.7071068],
               "points": [ { "position": [1,2,3] }, { "weight": 0.25 } ], "weights": [0, 0.5, 1], "tags": ["\u00e9", "a/b"] } },
    {
      "name": "Väter/x",
      "parent": "Dust",
      "transform": {
        "translation": [1.5, -2e-3, 100000],
        "scale": 2
      }
    },
    { "tag": {}, "parent": "Dust" }
  ]
}
)";

/// A registry, settings and a world to load scenes into.
struct Stage {
    ComponentRegistry registry;
    Settings settings;
    RenderOptions options;
    World world{registry};

    Stage() {
        registry.add<Transform>();
        registry.add<WorldMatrix>();
        registry.add<Fog>();
        registry.add<Tag>();
        settings.add<March>();
    }
    SceneFile load(std::string_view text) {
        SceneFile scene = SceneFile::parse(std::string(text), "test.json");
        scene.instantiate(world, settings, options);
        return scene;
    }
    Entity named(std::string_view name) { return world.find_named(name); }
};

/// What is wrong with a scene, a line for each problem; empty when nothing is.
inline std::string problems_of(std::string_view text) {
    Stage stage;
    try {
        stage.load(text);
        return {};
    } catch (const Error& error) {
        return error.what();
    }
}

/// A scene of one entity with these members.
inline std::string scene_with(std::string_view members) {
    return "{ \"tyndall\": 1,\n  \"entities\": [\n    { " + std::string(members) + " }\n  ]\n}\n";
}

}  // namespace tyndall::scene_test
