// Light against closed forms.

#include <numbers>

#include "physics/physics.h"
#include "physics/tables.h"
#include "render/light_state.h"
#include "renderer_fixture.h"
#include "scene/environment.h"

namespace tyndall {
namespace {

using test::add;
using test::directional;
using test::looking;
using test::material;
using test::plane_mesh;
using test::point;
using test::scaled;
using test::sphere_mesh;
using test::spot;
using test::translated;

constexpr float kPi = std::numbers::pi_v<float>;

/// A floor of 20 m seen from 3 m above by a camera that looks straight down at the origin.
RenderScene floor_of(const std::shared_ptr<const Material>& material) {
    RenderScene scene;
    add(scene, plane_mesh(), material, scaled(glm::vec3(10.0f)));
    scene.camera.transform = looking({0, 3, 0}, {0, 0, 0}, {0, 0, -1});
    return scene;
}

/// A material that only scatters diffusely: no dielectric layer.
std::shared_ptr<Material> lambertian(float albedo) {
    auto made = material(glm::vec3(albedo), 0.0f, 1.0f);
    made->specular = 0.0f;
    return made;
}

class RendererLightTest : public RendererTest, public testing::WithParamInterface<const char*> {
 protected:
    void SetUp() override {
        RendererTest::SetUp();
        renderer_->set_path(GetParam());
    }
    /// The radiance that the pixel in the middle shows.
    float seen(const RenderScene& scene) { return centre(render(scene, {321, 181})).y; }
};

TEST_P(RendererLightTest, SunOnWhiteIsAlbedoOverPi) {
    RenderScene scene = floor_of(lambertian(0.8f));
    scene.lights = {directional({0, -1, 0}, glm::vec3(100000.0f))};
    EXPECT_NEAR(seen(scene), 100000.0f * 0.8f / kPi, 0.005f * 100000.0f * 0.8f / kPi);
    scene.lights = {directional(glm::normalize(glm::vec3(0, -1, 1)), glm::vec3(100000.0f))};
    EXPECT_NEAR(seen(scene), 70710.68f * 0.8f / kPi, 0.005f * 70710.68f * 0.8f / kPi);
}

TEST_P(RendererLightTest, TheStandardMaterialIsThatOfPhysics) {
    const physics::SpecularTable table = physics::make_specular_table();
    for (const float metallic : {0.0f, 0.4f, 1.0f})
        for (const float roughness : {0.15f, 0.5f, 1.0f}) {
            RenderScene scene = floor_of(material(glm::vec3(0.6f), metallic, roughness));
            const glm::vec3 travel = glm::normalize(glm::vec3(0.2f, -1.0f, 0.1f));
            scene.lights = {directional(travel, glm::vec3(1000.0f))};
            const glm::vec3 up(0, 1, 0);
            const auto standard = physics::standard_material(glm::vec3(0.6f), metallic, 1.5f, 1.0f, glm::vec3(1.0f));
            const float expected =
                physics::standard_compose(standard, table.sample(1.0f, roughness),
                                          physics::standard_light(up, up, -travel, roughness, glm::vec3(1000.0f)))
                    .y;
            EXPECT_NEAR(seen(scene), expected, 0.005f * expected) << metallic << " " << roughness;
        }
}

TEST_P(RendererLightTest, PointLightsFollowTheInverseSquare) {
    RenderScene scene = floor_of(lambertian(0.5f));
    for (const glm::vec3 at :
         {glm::vec3(0, 0.5f, 0), glm::vec3(0, 2, 0), glm::vec3(1.5f, 1, 0.5f), glm::vec3(4, 6, 0)}) {
        scene.lights = {point(at, glm::vec3(250.0f))};
        const float expected = 250.0f * at.y / std::pow(glm::length(at), 3.0f) * 0.5f / kPi;
        EXPECT_NEAR(seen(scene), expected, 0.005f * expected) << at.x << " " << at.y;
    }
    scene.lights = {point({0, 2, 0}, glm::vec3(250.0f))};
    scene.lights[0].range_m = 2.5f;
    const float window = physics::range_window(2.0f, 2.5f);
    EXPECT_NEAR(seen(scene), 250.0f / 4.0f * window * 0.5f / kPi, 0.05f);
    scene.lights[0].range_m = 1.9f;
    EXPECT_EQ(seen(scene), 0.0f);
}

TEST_P(RendererLightTest, SpotsEndAtTheirCone) {
    RenderScene scene = floor_of(lambertian(0.5f));
    const float full = 600.0f / 9.0f * 0.5f / kPi;
    scene.lights = {spot({0, 3, 0}, {0, 0, 0}, glm::vec3(600.0f), 0.2f, 0.3f)};
    EXPECT_NEAR(seen(scene), full, 0.005f * full);
    // aimed aside, so that the middle lies in the soft edge; and wide enough to be drawn as a sphere
    for (const auto& [aside, outer] : {std::pair(0.25f, 0.3f), std::pair(1.0f, 1.3f)}) {
        scene.lights = {spot({0, 3, 0}, {3.0f * std::tan(aside), 0, 0}, glm::vec3(600.0f), 0.2f, outer)};
        const float falloff = physics::spot_falloff(0, std::cos(aside), std::cos(0.2f), std::cos(outer));
        ASSERT_GT(falloff, 0.01f);
        EXPECT_NEAR(seen(scene), full * falloff, 0.01f * full * falloff + 1e-4f) << outer;
    }
    scene.lights = {spot({0, 3, 0}, {3.0f * std::tan(0.35f), 0, 0}, glm::vec3(600.0f), 0.2f, 0.3f)};
    EXPECT_EQ(seen(scene), 0.0f);
}

TEST_P(RendererLightTest, LightVolumesHideNothing) {
    // a light's volume leaves out no pixel: near, inside, outside of the volume, and with several lights adding
    RenderScene scene = floor_of(lambertian(0.5f));
    scene.lights = {point({0, 1, 0}, glm::vec3(10.0f)), spot({2, 2, 0}, {2, 0, 0}, glm::vec3(90.0f), 0.5f, 1.0f)};
    for (const glm::vec3 eye : {glm::vec3(0, 3, 0.01f), glm::vec3(0.3f, 0.9f, 0.3f), glm::vec3(6, 1, 2)}) {
        scene.camera.transform = looking(eye, {0, 0, 0});
        const Image image = render(scene, {97, 61});
        const glm::mat4& camera = scene.camera.transform;
        const float tan_half = std::tan(0.5f * scene.camera.vertical_fov);
        int compared = 0;
        for (int y = 0; y < image.height; y += 4)
            for (int x = 0; x < image.width; x += 4) {
                const glm::vec2 ndc = 2.0f * (glm::vec2(x, y) + 0.5f) / glm::vec2(image.width, image.height) - 1.0f;
                const glm::vec3 ray(camera * glm::vec4(ndc.x * tan_half * 97.0f / 61.0f, -ndc.y * tan_half, -1, 0));
                if (ray.y >= 0.0f) continue;
                const glm::vec3 p = eye - ray * (eye.y / ray.y);
                if (std::max(std::abs(p.x), std::abs(p.z)) > 9.9f) continue;
                const glm::vec3 a = glm::vec3(0, 1, 0) - p;
                const glm::vec3 b = glm::vec3(2, 2, 0) - p;
                const float cone = physics::spot_falloff(0, glm::normalize(b).y, std::cos(0.5f), std::cos(1.0f));
                const float lux =
                    10.0f * a.y / std::pow(glm::length(a), 3.0f) + 90.0f * b.y * cone / std::pow(glm::length(b), 3.0f);
                ASSERT_NEAR(image.at(x, y, 1), lux * 0.5f / kPi, 0.01f * lux + 1e-4f) << x << " " << y;
                ++compared;
            }
        EXPECT_GT(compared, 100);
    }
}

TEST_P(RendererLightTest, AShadowedPointIsDark) {
    RenderScene scene = floor_of(lambertian(0.8f));
    add(scene, plane_mesh(), lambertian(0.8f), translated({0, 5, 0}) * scaled(glm::vec3(1.0f)));
    scene.surfaces[1].material = [] {
        auto both = lambertian(0.8f);
        both->double_sided = true;
        return both;
    }();
    for (Light light : {directional({0, -1, 0}, glm::vec3(1000.0f)), point({0, 7, 0}, glm::vec3(1000.0f)),
                        spot({0, 7, 0}, {0, 0, 0}, glm::vec3(1000.0f), 0.2f, 0.3f)}) {
        light.shadow.enabled = false;
        scene.lights = {light};
        EXPECT_GT(seen(scene), 1.0f);
        scene.lights[0].shadow.enabled = true;
        EXPECT_EQ(seen(scene), 0.0f) << int(light.kind);
        scene.sky.radiance = glm::vec3(2.0f);  // only the indirect light is left
        const float indirect = seen(scene);
        EXPECT_NEAR(indirect, 2.0f * 0.8f, 0.02f);
        scene.sky.radiance = glm::vec3(0.0f);
    }
}

/// Smallest and largest value over the inner part of a sphere that fills the picture's height.
std::pair<float, float> over_sphere(const Image& image) {
    float low = 1e9f;
    float high = 0.0f;
    const glm::vec2 middle = 0.5f * glm::vec2(image.width, image.height);
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            if (glm::length(glm::vec2(x, y) + 0.5f - middle) > 0.42f * float(image.height)) continue;
            low = std::min(low, image.at(x, y, 1));
            high = std::max(high, image.at(x, y, 1));
        }
    return {low, high};
}

TEST_P(RendererLightTest, TheWhiteFurnaceStaysWhite) {
    for (const bool image : {false, true}) {
        RenderScene scene;
        scene.sky.radiance = glm::vec3(10.0f);
        if (image) scene.sky.image = test::probe_image(64, [](glm::vec3) { return glm::vec3(1.0f); });
        add(scene, sphere_mesh(), material(glm::vec3(1.0f), 0.0f, 0.0f), translated({0, 0, -4}));
        scene.camera.vertical_fov = 2.0f * std::asin(0.25f) * 1.1f;
        for (const float metallic : {0.0f, 1.0f})
            for (const float roughness : {0.0f, 0.25f, 0.5f, 0.75f, 1.0f}) {
                scene.surfaces[0].material = material(glm::vec3(1.0f), metallic, roughness);
                const auto [low, high] = over_sphere(render(scene, {128, 128}));
                EXPECT_GE(low, 9.7f) << metallic << " " << roughness;
                EXPECT_LE(high, 10.01f) << metallic << " " << roughness;
            }
    }
}

TEST_P(RendererLightTest, ProbesLightWhatLiesInTheirBoxes) {
    RenderScene scene = floor_of(lambertian(1.0f));
    LightProbe room;
    room.image = test::probe_image(32, [](glm::vec3) { return glm::vec3(1.0f); });
    room.intensity = 3.0f;
    room.extent_m = glm::vec3(1.0f);
    room.blend_m = 0.5f;
    LightProbe outside = room;
    outside.image = test::probe_image(32, [](glm::vec3 d) { return glm::vec3(d.y > 0 ? 2.0f : 0.0f); });
    outside.intensity = 1.0f;
    outside.extent_m.reset();
    scene.probes = {room, outside};
    EXPECT_NEAR(seen(scene), 3.0f, 0.01f);
    const auto moved = [&](float x) {
        scene.probes[0].transform = translated({x, 0, 0});
        return seen(scene);
    };
    EXPECT_NEAR(moved(5.0f), 2.0f, 0.06f);                   // upper half white: harmonics ring by some 2 %
    EXPECT_NEAR(moved(0.75f), 0.5f * (3.0f + 2.0f), 0.05f);  // half way through its fading edge
    scene.probes.pop_back();
    scene.sky.radiance = glm::vec3(7.0f);
    EXPECT_NEAR(moved(5.0f), 7.0f, 0.05f);  // without a probe for the whole scene, the sky
}

TEST_P(RendererLightTest, LightsStandForTheEnvironment) {
    RenderScene scene = floor_of(lambertian(1.0f));
    scene.sky.radiance = glm::vec3(1.0f);
    scene.sky.image = test::probe_image(128, [](glm::vec3 d) { return glm::vec3(d.y > 0 ? 2.0f : 0.0f); });
    scene.sky.lights.count = 64;
    const RenderScene unlit = scene;
    EXPECT_FALSE(has_light_all_around(scene));
    EXPECT_TRUE(has_surroundings(scene));
    EXPECT_NEAR(seen(scene), 0.0f, 1e-6f) << "its diffuse light comes from the lights alone";
    LightsOfEnvironment lights;
    lights.add_to(scene);
    EXPECT_NEAR(seen(scene), 2.0f, 0.02f);
    // what mirrors shows the image, and no light as a highlight
    for (const float roughness : {0.0f, 0.5f}) {
        scene.surfaces[0].material = material(glm::vec3(1.0f), 1.0f, roughness);
        const float with_lights = seen(scene);
        RenderScene without = unlit;
        without.surfaces[0].material = scene.surfaces[0].material;
        EXPECT_EQ(with_lights, seen(without)) << roughness;
        without.sky.lights.count = 0;
        EXPECT_NEAR(with_lights, seen(without), 1e-3f) << roughness;
    }
}

TEST_P(RendererLightTest, MirrorsShowTheProbe) {
    RenderScene scene = floor_of(material(glm::vec3(1.0f), 1.0f, 0.0f));
    scene.sky.radiance = glm::vec3(1.0f);
    scene.sky.image = test::probe_image(128, [](glm::vec3 d) { return 0.5f + 0.5f * d; });
    scene.camera.transform = looking({0, 2, 3}, {0, 0, 0});
    const glm::vec3 mirrored = glm::normalize(glm::vec3(0, 2, -3));
    glm::vec3 colour = centre(render(scene, {321, 181}));
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(colour[c], 0.5f + 0.5f * mirrored[c], 0.02f) << c;
    scene.sky.rotation = glm::mat3(glm::vec3(0, 0, -1), glm::vec3(0, 1, 0), glm::vec3(1, 0, 0));  // image +X at -Z
    colour = centre(render(scene, {321, 181}));
    const glm::vec3 in_image = glm::transpose(scene.sky.rotation) * mirrored;
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(colour[c], 0.5f + 0.5f * in_image[c], 0.02f) << c;
    // a mirror inside a box shows the wall where the ray meets it
    LightProbe room;
    room.image = scene.sky.image;
    room.extent_m = glm::vec3(4.0f, 1.0f, 4.0f);
    room.blend_m = 0.01f;
    scene.probes = {room};
    colour = centre(render(scene, {321, 181}));
    const glm::vec3 wall = glm::normalize(mirrored / mirrored.y);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(colour[c], 0.5f + 0.5f * wall[c], 0.02f) << c;
}

INSTANTIATE_TEST_SUITE_P(Paths, RendererLightTest, testing::Values("deferred", "light_pre_pass"),
                         [](const auto& info) { return std::string(info.param); });

}  // namespace
}  // namespace tyndall
