#include <gtest/gtest.h>

#include <fstream>
#include <glm/gtc/matrix_transform.hpp>

#include "color/color.h"
#include "core/paths.h"
#include "ecs/transform.h"
#include "scene/components.h"
#include "scene/environment.h"
#include "scene/extraction.h"
#include "scene/scene_file.h"
#include "temporary_folder.h"

namespace tyndall {
namespace {

/// One triangle, a lamp and a camera below a node that is turned and moved.
constexpr std::string_view kGltf = R"({
  "asset": { "version": "2.0" }, "scene": 0, "scenes": [ { "nodes": [0] } ],
  "extensionsUsed": ["KHR_lights_punctual"],
  "extensions": { "KHR_lights_punctual": { "lights": [ { "type": "point", "intensity": 7, "color": [1, 0.5, 0] } ] } },
  "nodes": [
    { "name": "root", "translation": [0, 1, 0], "scale": [2, 2, 2], "children": [1, 2, 3] },
    { "name": "glass_pane", "mesh": 0, "translation": [1, 0, 0] },
    { "name": "lamp", "translation": [0, 0, 3], "extensions": { "KHR_lights_punctual": { "light": 0 } } },
    { "name": "eye", "camera": 0 } ],
  "cameras": [ { "type": "perspective", "perspective": { "yfov": 0.5, "znear": 0.25 } } ],
  "materials": [ { "name": "red", "pbrMetallicRoughness": { "baseColorFactor": [1, 0, 0, 1] }, "emissiveFactor": [1, 1, 0.5] } ],
  "meshes": [ { "primitives": [ { "attributes": { "POSITION": 0 }, "material": 0 } ] } ],
  "accessors": [ { "bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3", "min": [0, 0, 0], "max": [1, 1, 0] } ],
  "bufferViews": [ { "buffer": 0, "byteLength": 36 } ],
  "buffers": [ { "byteLength": 36, "uri": "data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA" } ] })";

class Extraction : public TemporaryFolder {
 protected:
    void SetUp() override {
        TemporaryFolder::SetUp();
        std::ofstream(folder_ / "thing.gltf") << kGltf;
        assets_ = std::make_unique<AssetStore>(config_, folder_);
        register_engine_components(registry_, extractors_);
    }
    /// Makes the entities of a scene file's "entities".
    void load(std::string_view entities) {
        SceneFile scene = SceneFile::parse("{ \"tyndall\": 1, \"entities\": [ " + std::string(entities) + " ] }", "t");
        scene.instantiate(world_, settings_, options_);
    }
    std::vector<std::string> extract(std::string_view camera = {}) {
        std::vector<std::string> texts;
        for (const ExtractionProblem& problem : extractors_.extract(world_, *assets_, camera, scene_))
            texts.push_back(problem.text);
        return texts;
    }

    ColorConfig config_{paths::root() / "config" / "color" / "tyndall.ocio"};
    std::unique_ptr<AssetStore> assets_;
    ComponentRegistry registry_;
    Extractors extractors_;
    Settings settings_;
    RenderOptions options_;
    World world_{registry_};
    RenderScene scene_;
};

TEST_F(Extraction, LightsComeInTheRenderersUnits) {
    load(R"({ "transform": { "translation": [1, 2, 3], "scale": 5 },
              "spot_light": { "intensity_cd": 100, "colour": [1, 0.5, 0], "inner_angle_deg": 60, "outer_angle_deg": 30,
                              "range_m": 9, "shadow": { "size": 256 } } },
            { "directional_light": { "illuminance_lux": 1000, "angular_diameter_deg": 2, "shadow": { "cascades": 2 } } },
            { "point_light": {} })");
    EXPECT_TRUE(extract().empty());
    ASSERT_EQ(scene_.lights.size(), 3u);
    const auto of = [&](LightKind kind) {
        return *std::find_if(scene_.lights.begin(), scene_.lights.end(),
                             [&](const Light& l) { return l.kind == kind; });
    };
    const Light spot = of(LightKind::spot);
    EXPECT_EQ(spot.intensity, glm::vec3(100, 50, 0));
    EXPECT_FLOAT_EQ(spot.outer_angle, glm::radians(30.0f));
    EXPECT_EQ(spot.inner_angle, spot.outer_angle);
    EXPECT_EQ(spot.transform, glm::translate(glm::mat4(1.0f), {1, 2, 3})) << "rigid";
    EXPECT_TRUE(spot.shadow.enabled);
    EXPECT_EQ(spot.shadow.size, 256);
    EXPECT_FLOAT_EQ(of(LightKind::directional).angular_radius, glm::radians(1.0f));
    EXPECT_EQ(of(LightKind::directional).shadow.cascades, 2);
    EXPECT_FALSE(of(LightKind::point).shadow.enabled);
}

TEST_F(Extraction, GltfNodesGlowAsTheFirstPatternThatFitsSays) {
    load(R"({ "name": "Plain", "gltf": { "file": "thing.gltf" } },
            { "gltf": { "file": "thing.gltf", "glow": [ { "nodes": "lamp_*", "factor": [9, 9, 9] },
                        { "nodes": "glass_*", "factor": [0.5, 0.25, 0] }, { "nodes": "*", "factor": [9, 9, 9] } ] } })");
    EXPECT_TRUE(extract().empty());
    ASSERT_EQ(scene_.surfaces.size(), 2u);
    const std::shared_ptr<const Material> plain = scene_.surfaces[0].material, dimmed = scene_.surfaces[1].material;
    EXPECT_EQ(plain->emissive, glm::vec3(1, 1, 0.5f));
    EXPECT_EQ(dimmed->emissive, glm::vec3(0.5f, 0.25f, 0));
    EXPECT_EQ(dimmed->base_colour, plain->base_colour);
    EXPECT_NE(dimmed->id, plain->id);
    extract();
    EXPECT_EQ(scene_.surfaces[1].material, dimmed) << "made anew for another frame";
}

TEST_F(Extraction, GltfNodesAreSurfacesLightsAndCameras) {
    load(R"({ "name": "Thing", "transform": { "translation": [10, 0, 0] }, "collider": {},
              "gltf": { "file": "thing.gltf", "cast_shadow_exclude": ["glass_*"] } })");
    EXPECT_TRUE(extract().empty());
    ASSERT_EQ(scene_.surfaces.size(), 1u);
    const Surface& pane = scene_.surfaces[0];
    EXPECT_EQ(glm::vec3(pane.transform[3]), glm::vec3(12, 1, 0));
    EXPECT_EQ(pane.bounds.low, glm::vec3(12, 1, 0));
    EXPECT_EQ(pane.bounds.high, glm::vec3(14, 3, 0));
    EXPECT_FALSE(pane.casts_shadow);
    EXPECT_TRUE(pane.collides);
    EXPECT_EQ(pane.material->base_colour, glm::vec4(1, 0, 0, 1));
    ASSERT_EQ(scene_.lights.size(), 1u);
    EXPECT_EQ(scene_.lights[0].intensity, glm::vec3(7, 3.5f, 0));
    EXPECT_EQ(glm::vec3(scene_.lights[0].transform[3]), glm::vec3(10, 1, 6));
    EXPECT_NEAR(glm::length(glm::vec3(scene_.lights[0].transform[0])), 1.0f, 1e-6f);
    EXPECT_EQ(scene_.camera.entity, world_.find_named("Thing"));
    EXPECT_FLOAT_EQ(scene_.camera.vertical_fov, 0.5f);

    // The next frame knows where everything was, and nothing is made anew.
    const Surface before = pane;
    world_.find<Transform>(world_.find_named("Thing"))->translation.x = 11.0f;
    extract();
    EXPECT_EQ(scene_.surfaces[0].previous_transform, before.transform);
    EXPECT_EQ(glm::vec3(scene_.surfaces[0].transform[3]), glm::vec3(13, 1, 0));
    EXPECT_EQ(scene_.surfaces[0].mesh, before.mesh);
    EXPECT_EQ(scene_.surfaces[0].material, before.material);
}

TEST_F(Extraction, MaterialsAreMadeOnceForEachContent) {
    load(R"({ "name": "Ball", "mesh": { "primitive": "sphere" }, "material": { "base_colour": [1, 0, 0] } },
            { "mesh": { "primitive": "sphere" } }, { "mesh": { "primitive": "box" } })");
    EXPECT_TRUE(extract().empty());
    ASSERT_EQ(scene_.surfaces.size(), 3u);
    const auto ball = [&] {
        return *std::find_if(scene_.surfaces.begin(), scene_.surfaces.end(),
                             [&](const Surface& s) { return s.entity == world_.find_named("Ball"); });
    };
    const Surface before = ball();
    EXPECT_EQ(before.material->base_colour, glm::vec4(1, 0, 0, 1));
    size_t same_mesh = 0;
    for (const Surface& surface : scene_.surfaces) same_mesh += surface.mesh == before.mesh ? 1 : 0;
    EXPECT_EQ(same_mesh, 2u);
    extract();
    EXPECT_EQ(ball().material, before.material);
    world_.find<MaterialComponent>(world_.find_named("Ball"))->roughness = 0.1f;
    extract();
    EXPECT_NE(ball().material->id, before.material->id);
    EXPECT_EQ(ball().material->roughness, 0.1f);
    EXPECT_EQ(ball().mesh, before.mesh);
}

TEST_F(Extraction, InteriorsComeInPerMetreWhateverTheirOptics) {
    const auto interior = [&](const std::string& component) {
        for (const Entity entity : world_.entities()) world_.destroy(entity);
        load(R"({ "transform": { "scale": 2 }, "mesh": { "primitive": "sphere" }, "interior": )" + component + " }");
        const std::vector<std::string> problems = extract();
        EXPECT_TRUE(problems.empty()) << problems.front();
        return scene_.surfaces.at(0).interior.value();
    };
    const auto expect_near = [](const glm::vec3& value, const glm::vec3& expected) {
        for (int i = 0; i < 3; ++i) EXPECT_NEAR(value[i], expected[i], 1e-4f * std::max(expected[i], 1.0f));
    };
    ScatteringInterior made = interior(R"({ "preset": "potato", "priority": 3 })");
    expect_near(made.sigma_s_per_m, {680, 700, 550});
    expect_near(made.sigma_a_per_m, {2.4f, 9, 120});
    EXPECT_EQ(made.eta, 1.3f);
    EXPECT_EQ(made.priority, 3);
    EXPECT_EQ(made.phase.kind, PhaseKind::isotropic);
    made = interior(R"({ "preset": "potato", "phase": { "henyey_greenstein": { "g": 0.9 } } })");
    expect_near(made.sigma_s_per_m, {6800, 7000, 5500});
    made = interior(R"({ "optics": { "coefficients_per_m": { "scattering": [1, 2, 3], "absorption": [4, 5, 6] } },
                         "phase": { "henyey_greenstein": { "g": 0.9 } }, "ior": 1, "roughness": 0.5,
                         "emission_cd_m2_per_m": [7, 8, 9] })");
    EXPECT_EQ(made.sigma_s_per_m, glm::vec3(1, 2, 3)) << "not reduced";
    EXPECT_EQ(made.sigma_a_per_m, glm::vec3(4, 5, 6));
    EXPECT_EQ(made.emission_cd_m2_per_m, glm::vec3(7, 8, 9));
    EXPECT_EQ(made.eta, 1.0f);
    EXPECT_EQ(made.roughness, 0.5f);
    made = interior(R"({ "optics": { "albedo": { "albedo": [0.9, 0.5, 0], "mean_free_path_mm": [1, 2, 4] } } })");
    expect_near(made.sigma_s_per_m, {900, 250, 0});
    expect_near(made.sigma_a_per_m, {100, 250, 250});
    made = interior(R"({ "optics": { "transmission_colour": { "colour": [0.5, 1, 0.25], "at_m": 0.1 } } })");
    expect_near(made.sigma_a_per_m, {6.93147f, 0, 13.86294f});
    EXPECT_EQ(made.sigma_s_per_m, glm::vec3(0));
    // a colour of 1 / e after 10 mm: clear (the coefficient itself), in between (1 / tanh(1) - 1), milky (k^2 / 3 s)
    made = interior(R"({ "optics": { "transport_colour": { "colour": [0.36787944, 0.36787944, 0.36787944], "at_m": 0.01,
                         "mean_free_path_mm": [1e6, 10, 0.1] } }, "phase": { "henyey_greenstein": { "g": 0.5 } } })");
    expect_near(made.sigma_a_per_m, {99.999f, 31.30353f, 0.333311f});
    expect_near(made.sigma_s_per_m, {0.002f, 200, 20000});
}

TEST_F(Extraction, AnInteriorsVolumeFillsTheMesh) {
    std::ofstream(folder_ / "v.raw", std::ios::binary) << std::string(8, '\xff');
    std::ofstream(folder_ / "v.json") << R"({ "raw": "v.raw", "type": "u8", "size": [2, 4, 1], "voxel_m": [1, 1, 1] })";
    const auto corner = [&](const std::string& fit) {
        for (const Entity entity : world_.entities()) world_.destroy(entity);
        load(R"({ "transform": { "scale": [8, 8, 2] }, "mesh": { "primitive": "box" },
                  "interior": { "density": { "volume": { "file": "v.json", "scale": 3, "fit": ")" +
             fit + R"(" } } } })");
        EXPECT_TRUE(extract().empty());
        const auto& grid = std::get<GridDensity>(scene_.surfaces.at(0).interior.value().density);
        EXPECT_EQ(grid.scale, 3.0f);
        return grid.to_volume * glm::vec4(0.25f, 0.5f, 0.5f, 1.0f);
    };
    EXPECT_EQ(corner("stretch"), glm::vec4(0.75f, 1, 1, 1));
    EXPECT_EQ(corner("contain"), glm::vec4(1, 1, 1, 1)) << "4 x 8 x 2 m of the 8 x 8 x 2 m";
}

TEST_F(Extraction, OnlyMeshesHaveInteriorsAndClearMaterialsMakeTheirOwn) {
    load(R"({ "name": "Nothing", "interior": {} },
            { "mesh": { "primitive": "sphere" },
              "material": { "transmission": 1, "thickness_m": 0.1, "ior": 1.4, "roughness": 0.2,
                            "attenuation_colour": [0.5, 1, 1], "attenuation_distance_m": 0.5 } },
            { "mesh": { "primitive": "sphere" }, "material": { "transmission": 1 } },
            { "mesh": { "primitive": "sphere" }, "interior": { "phase": { "tabulated": { "file": "none.txt" } } } })");
    const std::vector<std::string> problems = extract();
    ASSERT_EQ(problems.size(), 2u);
    EXPECT_NE((problems[0] + problems[1]).find("needs a mesh"), std::string::npos);
    EXPECT_NE((problems[0] + problems[1]).find("none.txt"), std::string::npos);
    ASSERT_EQ(scene_.surfaces.size(), 2u);
    std::vector<ScatteringInterior> made;
    for (const Surface& surface : scene_.surfaces)
        if (surface.interior) made.push_back(*surface.interior);
    ASSERT_EQ(made.size(), 1u) << "without a thickness it is a thin wall";
    EXPECT_NEAR(made[0].sigma_a_per_m.x, std::log(2.0f) / 0.5f, 1e-5f);
    EXPECT_EQ(made[0].sigma_a_per_m.y, 0.0f);
    EXPECT_EQ(made[0].eta, 1.4f);
    EXPECT_EQ(made[0].roughness, 0.2f);
}

TEST_F(Extraction, ErrorsAreReportedOnceAndLeaveTheEntityOut) {
    load(
        R"({ "name": "Broken", "mesh": { "file": "none.obj" } }, { "name": "Fine", "mesh": { "primitive": "plane" } })");
    const std::vector<std::string> problems = extract();
    ASSERT_EQ(problems.size(), 1u);
    EXPECT_NE(problems[0].find("entity 'Broken', mesh: "), std::string::npos) << problems[0];
    EXPECT_NE(problems[0].find("none.obj"), std::string::npos) << problems[0];
    EXPECT_EQ(scene_.surfaces.size(), 1u);
    EXPECT_TRUE(extract().empty());
    world_.find<MeshComponent>(world_.find_named("Broken"))->primitive = Primitive::box;
    EXPECT_EQ(extract().size(), 1u) << "a file and a primitive: another error";
    world_.find<MeshComponent>(world_.find_named("Broken"))->file.clear();
    EXPECT_TRUE(extract().empty());
    EXPECT_EQ(scene_.surfaces.size(), 2u);
    world_.find<MeshComponent>(world_.find_named("Broken"))->file = "none.obj";
    EXPECT_EQ(extract().size(), 1u) << "broken again";
}

TEST_F(Extraction, AFailedExtractorTakesBackWhatItAdded) {
    extractors_.add("camera_path", [](const ExtractContext&, const void*, RenderScene& scene) {
        scene.surfaces.emplace_back();
        scene.sky.radiance = glm::vec3(1.0f);
        throw Error("half done");
    });
    load(R"({ "camera_path": {} })");
    EXPECT_EQ(extract().size(), 1u);
    EXPECT_TRUE(scene_.surfaces.empty());
    EXPECT_EQ(scene_.sky.radiance, glm::vec3(0.0f));
    extractors_.remove("camera_path");
    EXPECT_TRUE(extract().empty());
}

TEST_F(Extraction, ProbesComeBoxedFirstAndSmallestFirst) {
    extractors_.add("camera_path", [](const ExtractContext&, const void*, RenderScene& scene) {
        scene.probes.push_back({.intensity = 1.0f});
        scene.probes.push_back({.intensity = 2.0f, .extent_m = glm::vec3(4.0f)});
        scene.probes.push_back({.intensity = 3.0f, .extent_m = glm::vec3(1.0f, 9.0f, 2.0f)});
    });
    load(R"({ "camera_path": {} })");
    EXPECT_TRUE(extract().empty());
    std::vector<float> order;
    for (const LightProbe& probe : scene_.probes) order.push_back(probe.intensity);
    EXPECT_EQ(order, (std::vector<float>{3.0f, 2.0f, 1.0f}));
}

TEST_F(Extraction, TheEnvironmentBecomesLights) {
    load(
        R"({ "name": "Sky", "transform": { "rotation": [0, 0.70710678, 0, 0.70710678] }, "sky": { "probe": "assets:scenes/textures/evening.hdr",
              "lights": { "count": 16, "shadow": { "size": 512, "cascades": 1 } } } },
            { "name": "Sun", "directional_light": {} })");
    EXPECT_TRUE(extract().empty());
    ASSERT_EQ(scene_.lights.size(), 17u);
    EXPECT_FALSE(scene_.lights[0].of_environment) << "the scene's own come first";
    const std::vector<physics::DistantLight> expected = [&] {
        const Image small = small_environment(*scene_.sky.image);
        return physics::lights_of_equirect(pixels_of(small), small.width, small.height, 16);
    }();
    for (size_t i = 0; i < 16; ++i) {
        const Light& light = scene_.lights[i + 1];
        EXPECT_TRUE(light.of_environment);
        EXPECT_EQ(light.kind, LightKind::directional);
        EXPECT_TRUE(light.shadow.enabled);
        EXPECT_EQ(light.shadow.size, 512);
        EXPECT_EQ(light.intensity, expected[i].illuminance);
        const glm::vec3 d = expected[i].direction;  // a quarter turn about +Y takes +X to -Z
        EXPECT_LT(glm::distance(glm::vec3(light.transform[2]), glm::vec3(d.z, d.y, -d.x)), 1e-5f);
        EXPECT_NEAR(glm::determinant(light.transform), 1.0f, 1e-5f);
    }
    const glm::vec3 before = scene_.lights[1].intensity;
    world_.find<SkyComponent>(world_.find_named("Sky"))->intensity = 3.0f;
    extract();
    EXPECT_LT(glm::distance(scene_.lights[1].intensity, 3.0f * before), 1e-4f * glm::length(before));
    world_.find<SkyComponent>(world_.find_named("Sky"))->lights.count = 0;
    extract();
    EXPECT_EQ(scene_.lights.size(), 1u);
}

TEST_F(Extraction, OnlyWhatLightsTheSceneBecomesLights) {
    load(R"({ "name": "Sky", "sky": { "radiance_cd_m2": [1, 2, 3], "lights": { "count": 8 } } },
            { "name": "Probe", "light_probe": { "file": "assets:scenes/textures/evening.hdr", "lights": { "count": 4 } } },
            { "name": "Room", "light_probe": { "file": "assets:scenes/textures/evening.hdr", "extent_m": [1, 1, 1] } })");
    EXPECT_TRUE(extract().empty());
    ASSERT_EQ(scene_.lights.size(), 4u) << "a probe without a box stands in for the sky";
    EXPECT_EQ(scene_.lights[0].entity, world_.find_named("Probe"));
    world_.find<LightProbeComponent>(world_.find_named("Probe"))->lights.count = 0;
    extract();
    EXPECT_TRUE(scene_.lights.empty());
    world_.find<LightProbeComponent>(world_.find_named("Probe"))->extent_m = glm::vec3(1.0f);
    extract();
    ASSERT_EQ(scene_.lights.size(), 8u) << "the same radiance from everywhere";
    glm::vec3 sum(0.0f);
    for (const Light& light : scene_.lights) sum += light.intensity;
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(sum[c] / (4.0f * physics::kPi * float(c + 1)), 1.0f, 1e-4f);
}

TEST_F(Extraction, ChoosesTheCameraByName) {
    load(R"({ "name": "Nave", "camera": { "vertical_fov_deg": 90, "ev100": 3 } },
            { "name": "Altar", "camera": { "exposure": 2 } })");
    EXPECT_TRUE(extract().empty());
    EXPECT_EQ(scene_.camera.entity, world_.find_named("Nave"));
    EXPECT_FLOAT_EQ(scene_.camera.vertical_fov, glm::radians(90.0f));
    EXPECT_FALSE(scene_.camera.exposure.has_value());
    EXPECT_TRUE(extract("Altar").empty());
    EXPECT_EQ(scene_.camera.exposure, 2.0f);
    const std::vector<std::string> problems = extract("Alter");
    ASSERT_EQ(problems.size(), 1u);
    EXPECT_NE(problems[0].find("did you mean 'Altar'?"), std::string::npos) << problems[0];
    EXPECT_EQ(scene_.camera.entity, world_.find_named("Nave"));
    EXPECT_TRUE(extract("Alter").empty());
}

TEST_F(Extraction, SkyAndTimeSurviveClearing) {
    load(R"({ "sky": { "radiance_cd_m2": [1, 2, 3], "intensity": 2 } })");
    scene_.time_s = 1.5;
    scene_.frame = 9;
    scene_.camera_cut = true;
    extract();
    EXPECT_EQ(scene_.sky.radiance, glm::vec3(2, 4, 6));
    EXPECT_EQ(scene_.time_s, 1.5);
    EXPECT_EQ(scene_.frame, 9u);
    EXPECT_TRUE(scene_.camera_cut);
}

}  // namespace
}  // namespace tyndall
