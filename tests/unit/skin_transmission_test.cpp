// Light through slabs of skin, lit from behind, against the profile's table of what comes through.

#include <gtest/gtest.h>
#include <unistd.h>

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <string>

#include "app/engine.h"
#include "core/log.h"
#include "image/image_io.h"
#include "profile_choice.h"
#include "renderer_fixture.h"

namespace tyndall::skin {
namespace {

constexpr float kLux = 3.0f;

const std::string kSun = R"("directional_light": {"illuminance_lux": 3, "shadow": {"size": 512, "cascades": 1}})";
const std::string kBareSun = R"("directional_light": {"illuminance_lux": 3})";
const std::string kSky = R"("sky": {"radiance_cd_m2": [1, 1, 1]})";
const std::string kSpot =
    R"("spot_light": {"intensity_cd": 3, "inner_angle_deg": 4, "outer_angle_deg": 5, "shadow": {"size": 512}})";
const std::string kPoint = R"("point_light": {"intensity_cd": 3, "shadow": {"size": 1024}})";

/// A slab before the camera and a light, which stands 1 m away, `angle_deg` from behind the slab.
struct Slab {
    float thickness_mm = 2.0f;
    float angle_deg = 0.0f;
    std::string light = kSun;
    std::string profile = "skin_1";
    std::string technique = "separable";
    std::string more;  ///< entities, after a comma
    std::string path = "light_pre_pass";
    float side_m = 0.04f;
    std::string skin;  ///< fields, after a comma
};

class SkinTransmissionTest : public RendererTest {
 protected:
    void SetUp() override {
        RendererTest::SetUp();
        folder_ = std::filesystem::temp_directory_path() / ("tyndall_through_" + std::to_string(getpid()));
        std::filesystem::create_directories(folder_);
        Image fifth(4, 4, 1, Image::Type::u8);
        std::ranges::fill(fifth.bytes(), uint8_t(51));
        save_png(folder_ / "fifth.png", fifth);
        write_box();
    }

    /// A cube of side 1 whose faces have UVs of their own.
    void write_box() const {
        std::ofstream file(folder_ / "box.obj");
        for (int i = 0; i < 8; ++i)
            file << fmt::format("v {} {} {}\n", (i & 1) - 0.5, ((i >> 1) & 1) - 0.5, (i >> 2) - 0.5);
        for (int i = 0; i < 24; ++i)
            file << fmt::format("vt {} {}\n", 0.35 * (i / 4 % 3) + (i % 4 % 3 == 0 ? 0.02 : 0.28),
                                0.4 * (i / 12) + (i % 4 < 2 ? 0.02 : 0.28));
        constexpr int kFaces[6][4] = {{5, 6, 8, 7}, {2, 1, 3, 4}, {6, 2, 4, 8},
                                      {1, 5, 7, 3}, {7, 8, 4, 3}, {1, 2, 6, 5}};
        for (int f = 0; f < 6; ++f)
            file << fmt::format("f {}/{} {}/{} {}/{} {}/{}\n", kFaces[f][0], 4 * f + 1, kFaces[f][1], 4 * f + 2,
                                kFaces[f][2], 4 * f + 3, kFaces[f][3], 4 * f + 4);
    }
    void TearDown() override {
        std::filesystem::remove_all(folder_);
        RendererTest::TearDown();
    }

    /// What the compose pass gets, with the pass and without.
    Image render_slab(const Slab& slab, float transmission = 1.0f, const char* target = "light_diffuse") {
        const std::filesystem::path file = folder_ / "scene.json";
        const float angle = slab.angle_deg * std::numbers::pi_v<float> / 180.0f;
        std::ofstream(file) << fmt::format(
            R"({{"tyndall": 1, "modules": ["skin"],
          "render": {{"path": "{}", "image": {{"antialiasing": "none"}}}},
          "entities": [
          {{"name": "Camera", "transform": {{"translation": [0, 0, 0.15], "look_at": [0, 0, 0]}},
           "camera": {{"vertical_fov_deg": 6, "exposure": 1, "near_m": 0.001}}}},
          {{"name": "Light", "transform": {{"translation": [{}, 0, {}], "look_at": [0, 0, 0]}}, {}}},
          {{"name": "Slab", "transform": {{"translation": [0, 0, {}], "scale": [{}, {}, {}]}},
           "mesh": {{"file": "box.obj"}}, "material": {{"roughness": 1}},
           "skin": {{"profile": {{"{}": {{}}}}, "technique": "{}", "transmission": {}{}}}}}{}]}})",
            slab.path, std::sin(angle), -std::cos(angle), slab.light, -0.0005f * slab.thickness_mm, slab.side_m,
            slab.side_m, 0.001f * slab.thickness_mm, slab.profile, slab.technique, transmission, slab.skin, slab.more);
        Engine engine(true);
        engine.load_scene(file, {});
        engine.renderer().retain({target});
        engine.renderer().render(engine.extract(), {64, 64});
        EXPECT_EQ(engine.problems(), "");
        return picture(*engine.renderer().target(target));
    }

    std::filesystem::path folder_;
};

float most(const Image& image) {
    float value = 0.0f;
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x)
            for (int c = 0; c < 3; ++c) value = std::max(value, image.at(x, y, c));
    return value;
}

/// The largest difference of two pictures.
float apart(const Image& a, const Image& b) {
    float value = 0.0f;
    for (int y = 0; y < a.height; ++y)
        for (int x = 0; x < a.width; ++x)
            for (int c = 0; c < 3; ++c) value = std::max(value, std::abs(a.at(x, y, c) - b.at(x, y, c)));
    return value;
}

/// What a slab lit along its normal lets through, over the base colour.
glm::vec3 expected(const ProfileChoice& choice, float thickness_mm) {
    const auto made = made_profile(choice);
    return made->transmittance ? made->transmittance->at(0.001f * thickness_mm) / made->albedo
                               : made->profile.through(0.001f * thickness_mm);
}

TEST_F(SkinTransmissionTest, SlabsLetThroughWhatTheTableSays) {
    for (const float thickness : {1.0f, 2.0f, 3.0f, 5.0f})
        for (const char* profile : {"skin_1", "six_gaussians"}) {
            const glm::vec3 got = centre(render_slab({.thickness_mm = thickness, .profile = profile})) / kLux;
            const ProfileChoice choice =
                profile == std::string("skin_1") ? ProfileChoice(Skin1Profile{}) : ProfileChoice(SixGaussiansProfile{});
            const glm::vec3 wanted = expected(choice, thickness);
            std::printf("%s, %.0f mm: %.4f %.4f %.4f, should be %.4f %.4f %.4f\n", profile, double(thickness),
                        double(got.x), double(got.y), double(got.z), double(wanted.x), double(wanted.y),
                        double(wanted.z));
            for (int c = 0; c < 3; ++c) EXPECT_NEAR(got[c], wanted[c], 0.05f * wanted[c] + 0.001f);
        }
}

TEST_F(SkinTransmissionTest, SlantedLightGoesByTheCosine) {
    for (const float angle : {30.0f, 60.0f}) {
        const float cosine = std::cos(angle * std::numbers::pi_v<float> / 180.0f);
        const glm::vec3 got = centre(render_slab({.thickness_mm = 3, .angle_deg = angle})) / (kLux * cosine);
        const glm::vec3 straight = centre(render_slab({.thickness_mm = 3})) / kLux;
        std::printf("%.0f degrees: %.4f %.4f %.4f of what comes through straight\n", double(angle),
                    double(got.x / straight.x), double(got.y / straight.y), double(got.z / straight.z));
        // less of it enters at an angle, as the light pass has it
        for (int c = 0; c < 2; ++c) EXPECT_NEAR(got[c] / straight[c], 1.0f, 0.1f);
    }
}

TEST_F(SkinTransmissionTest, SpotsAndPointsAreAsTheSun) {
    const glm::vec3 sun = centre(render_slab({}));
    for (const std::string& light : {kSpot, kPoint}) {
        const glm::vec3 lamp = centre(render_slab({.light = light}));
        std::printf("lamp / sun: %.4f %.4f %.4f\n", double(lamp.x / sun.x), double(lamp.y / sun.y),
                    double(lamp.z / sun.z));
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(lamp[c], sun[c], 0.05f * sun[c]);
    }
}

TEST_F(SkinTransmissionTest, BoardsBehindTheSkinLeaveItDark) {
    for (const float behind_mm : {1.0f, 10.0f}) {
        const std::string board = fmt::format(
            R"(, {{"name": "Board", "transform": {{"translation": [0, 0, {}], "scale": [0.1, 0.1, 0.001]}},
                "mesh": {{"primitive": "box"}}, "material": {{}}}})",
            -0.002f - 0.0005f - 0.001f * behind_mm);
        const float glow = most(render_slab({.more = board}));
        std::printf("a board %.0f mm behind: %.6f\n", double(behind_mm), double(glow));
        EXPECT_LT(glow, 1e-4f);
    }
}

TEST_F(SkinTransmissionTest, LightFromTheFrontIsLeftAlone) {
    for (const float angle : {180.0f, 120.0f, 95.0f}) {
        const Slab slab{.angle_deg = angle};
        const float added = apart(render_slab(slab, 1.0f), render_slab(slab, 0.0f));
        std::printf("light from %.0f degrees: adds %.6f\n", double(angle), double(added));
        EXPECT_EQ(added, 0.0f);
    }
}

/// Fields of skin that is as thick as a map says.
std::string by_map(float thickness_mm) {
    return fmt::format(R"(, "maps": {{"thickness": "fifth.png"}}, "thickness_mm": {})", 5.0f * thickness_mm);
}

TEST_F(SkinTransmissionTest, ThicknessDoesForShadowMaps) {
    struct Case {
        const char* what;
        std::string light;
        std::string skin;
    };
    for (const float thickness : {1.0f, 3.0f}) {
        const glm::vec3 wanted = expected(Skin1Profile{}, thickness);
        for (const Case& c : {Case{"a map, light without shadows", kBareSun, by_map(thickness)},
                              Case{"baked, light without shadows", kBareSun, R"(, "thickness": "others")"},
                              Case{"baked, for all lights", kSun, R"(, "thickness": "all")"}}) {
            const Slab slab{.thickness_mm = thickness, .light = c.light, .side_m = 0.2f, .skin = c.skin};
            const glm::vec3 got = centre(render_slab(slab)) / kLux;
            std::printf("%.0f mm, %s: %.4f %.4f %.4f, should be %.4f %.4f %.4f\n", double(thickness), c.what,
                        double(got.x), double(got.y), double(got.z), double(wanted.x), double(wanted.y),
                        double(wanted.z));
            for (int k = 0; k < 3; ++k) EXPECT_NEAR(got[k], wanted[k], 0.05f * wanted[k] + 0.001f);
        }
    }
}

TEST_F(SkinTransmissionTest, LightFromAllAroundComesThrough) {
    for (const char* technique : {"separable", "hable"}) {
        const Slab slab{.thickness_mm = 3, .light = kSky, .technique = technique, .side_m = 0.2f, .skin = by_map(3)};
        const glm::vec3 got = centre(render_slab(slab)) - centre(render_slab(slab, 0.0f));
        const glm::vec3 wanted = std::numbers::pi_v<float> * expected(Skin1Profile{}, 3);
        std::printf("%s, even light: %.4f %.4f %.4f, should be %.4f %.4f %.4f\n", technique, double(got.x),
                    double(got.y), double(got.z), double(wanted.x), double(wanted.y), double(wanted.z));
        for (int k = 0; k < 3; ++k) EXPECT_NEAR(got[k], wanted[k], 0.02f * wanted[k] + 0.001f);
    }
}

TEST_F(SkinTransmissionTest, ThicknessLeavesTheRestAlone) {
    // lights with shadow maps go by these, light from the front comes through nothing, what is behind shades
    const float lamp = apart(render_slab({}), render_slab({.skin = by_map(2)}));
    const Slab front{.angle_deg = 180, .light = kBareSun, .skin = by_map(2)};
    const float added = apart(render_slab(front, 1.0f), render_slab(front, 0.0f));
    const std::string board =
        R"(, {"name": "Board", "transform": {"translation": [0, 0, -0.012], "scale": [0.1, 0.1, 0.001]},
            "mesh": {"primitive": "box"}, "material": {}})";
    const float glow = most(render_slab({.more = board, .skin = R"(, "thickness": "all")"}));
    std::printf("a map changes a lamp by %.6f, light from the front by %.6f; behind a board %.6f\n", double(lamp),
                double(added), double(glow));
    EXPECT_EQ(lamp, 0.0f);
    EXPECT_EQ(added, 0.0f);
    EXPECT_LT(glow, 1e-4f);
}

TEST_F(SkinTransmissionTest, AMissingMapOfThicknessIsNamed) {
    std::string logged;
    log::set_sink([&](log::Level level, std::string_view text) {
        if (level == log::Level::error) logged += text;
    });
    render_slab({.skin = R"(, "maps": {"thickness": "none.png"})"});
    log::set_sink({});
    std::printf("%s\n", logged.c_str());
    EXPECT_NE(logged.find("none.png: no such file"), std::string::npos);
}

TEST_F(SkinTransmissionTest, SkinInMapsGlowsAsWell) {
    const glm::vec3 screen = centre(render_slab({})), map = centre(render_slab({.technique = "six_gaussians"}));
    std::printf("in maps / on the screen: %.4f %.4f %.4f\n", double(map.x / screen.x), double(map.y / screen.y),
                double(map.z / screen.z));
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(map[c], screen[c], 0.01f * screen[c]);
}

TEST_F(SkinTransmissionTest, BothPathsAreOne) {
    const Image first = render_slab({.path = "light_pre_pass"}, 1.0f, "radiance");
    const Image second = render_slab({.path = "deferred"}, 1.0f, "radiance");
    std::printf("largest difference of both paths: %.6f of %.4f\n", double(apart(first, second)), double(most(first)));
    EXPECT_LT(apart(first, second), 1e-3f * most(first));
}

}  // namespace
}  // namespace tyndall::skin
