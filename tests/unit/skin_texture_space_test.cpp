// Techniques of skin in texture space from scene to picture: what the compose pass gets as irradiance.

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <utility>

#include "app/engine.h"
#include "image/compare.h"
#include "image/image_io.h"
#include "physics/diffusion_profile.h"
#include "renderer_fixture.h"

namespace tyndall::skin {
namespace {

constexpr float kSheet_m = 0.06f;

class SkinTextureSpaceTest : public RendererTest {
 protected:
    void SetUp() override {
        RendererTest::SetUp();
        folder_ = std::filesystem::temp_directory_path() / ("tyndall_skin_maps_" + std::to_string(getpid()));
        std::filesystem::create_directories(folder_);
        Image mask(1024, 4, 1, Image::Type::u8);
        for (int y = 0; y < 4; ++y)
            for (int x = 0; x < 1024; ++x) mask.bytes()[size_t(y * 1024 + x)] = x >= 512 ? 255 : 0;
        save_png(folder_ / "edge.png", mask);
        Image even(4, 4, 3, Image::Type::u8);
        std::ranges::fill(even.bytes(), uint8_t(160));
        save_png(folder_ / "even.png", even);
        Image two(1024, 4, 1, Image::Type::u8);
        for (int y = 0; y < 4; ++y)
            for (int x = 0; x < 1024; ++x) two.bytes()[size_t(y * 1024 + x)] = x >= 512 ? 230 : 90;
        save_png(folder_ / "two.png", two);
        Image checker(64, 64, 3, Image::Type::u8);
        for (int i = 0; i < 64 * 64; ++i)
            for (int c = 0; c < 3; ++c)
                checker.bytes()[size_t(3 * i + c)] =
                    uint8_t((i % 64 / 2 + i / 128) % 2 == 0 ? 235 - 30 * c : 120 - 40 * c);
        save_png(folder_ / "checker.png", checker);
        write_sheet("sheet.obj", 0.0f, 1.0f);
        write_sheet("half.obj", 0.25f, 0.75f);
        write_sheet("tiled.obj", 0.0f, 3.0f);
    }
    void TearDown() override {
        std::filesystem::remove_all(folder_);
        RendererTest::TearDown();
    }

    /// Faces +Z; metres.
    void write_sheet(const char* name, float low, float high) const {
        const float half = 0.5f * kSheet_m;
        std::ofstream(folder_ / name) << fmt::format(
            "v {0} {0} 0\nv {1} {0} 0\nv {1} {1} 0\nv {0} {1} 0\nvt {2} {2}\nvt {3} {2}\nvt {3} {3}\nvt {2} {3}\n"
            "vn 0 0 1\nf 1/1/1 2/2/1 3/3/1 4/4/1\n",
            -half, half, low, high);
    }

    struct Look {
        std::string technique, mesh = "sheet.obj", path = "deferred";
        float pre_scatter = 0.0f;
        int map_size = 512;
        float distance_m = 0.15f;
        float moved_m = 0.0f;  ///< the sheet, before a second picture
        std::string colour = "even.png";
        std::string slide = R"(, "gobo": "edge.png", "gobo_size_m": [0.04, 10])";
    };

    Image irradiance(const Look& look, const char* target = "light_diffuse") {
        const std::filesystem::path file = folder_ / "scene.json";
        std::ofstream(file) << fmt::format(
            R"({{"tyndall": 1, "modules": ["skin"],
          "render": {{"path": "{}", "image": {{"antialiasing": "none"}}, "skin": {{"texture_space": {{"size": {}}}}}}},
          "entities": [
          {{"name": "Camera", "transform": {{"translation": [0, 0, {}], "look_at": [0, 0, 0]}},
           "camera": {{"vertical_fov_deg": 10, "exposure": 1, "near_m": 0.001}}}},
          {{"name": "Sun", "directional_light": {{"illuminance_lux": 3{}}}}},
          {{"name": "Sheet", "mesh": {{"file": "{}"}},
           "material": {{"roughness": 1, "base_colour": [0.8, 0.5, 0.3], "base_colour_texture": "{}"}},
           "skin": {{"technique": "{}", "pre_scatter": {}, "transmission": 0}}}}]}})",
            look.path, look.map_size, look.distance_m, look.slide, look.mesh, look.colour, look.technique,
            look.pre_scatter);
        Engine engine(true);
        engine.load_scene(file, {});
        engine.renderer().retain({target});
        RenderScene scene = engine.extract();
        engine.renderer().render(scene, {kPixels, kPixels});
        if (look.moved_m != 0.0f) {
            scene.surfaces[0].transform[3].x += look.moved_m;
            engine.renderer().render(scene, {kPixels, kPixels});
        }
        EXPECT_EQ(engine.problems(), "");
        return picture(*engine.renderer().target(target));
    }

    /// RMS off the profile's response to the edge at x = 0, over what is fully lit.
    static glm::vec3 error_of(const Image& image, float distance_m) {
        const float pixel = 2.0f * distance_m * std::tan(0.5f * 10.0f * 0.0174533f) / float(kPixels);
        const physics::DiffusionProfile skin = physics::six_gaussian_skin();
        glm::vec3 sum(0.0f);
        const float lit = 3.0f * entering(image);
        for (int x = 0; x < kPixels; ++x) {
            const glm::vec3 wanted = skin.edge((float(x) + 0.5f - 0.5f * kPixels) * pixel);
            for (int c = 0; c < 3; ++c) {
                const float error = image.at(x, kPixels / 2, c) / lit - wanted[c];
                sum[c] += error * error / float(kPixels);
            }
        }
        return glm::sqrt(sum);
    }
    /// What enters of light along the normal, over that of even light.
    static float entering(const Image& image) { return image.at(kPixels - 1, kPixels / 2, 2) / 3.0f; }

    static constexpr int kPixels = 160;
    std::filesystem::path folder_;
};

TEST_F(SkinTextureSpaceTest, AKnifeEdgeInAScene) {
    for (const char* technique : {"six_gaussians", "hable"}) {
        const float most = technique[0] == 's' ? 0.01f : 0.05f;
        for (const float distance : {0.1f, 0.15f, 0.3f}) {
            const glm::vec3 error = error_of(irradiance({.technique = technique, .distance_m = distance}), distance);
            std::printf("%s from %.2f m: RMS %.4f %.4f %.4f\n", technique, double(distance), double(error.x),
                        double(error.y), double(error.z));
            EXPECT_LT(std::max({error.x, error.y, error.z}), most);
        }
    }
}

TEST_F(SkinTextureSpaceTest, MapsPathsAndColoursChangeLittle) {
    const Image plain = irradiance({.technique = "six_gaussians"});
    const auto farthest = [&](const Image& other) {
        float most = 0.0f;
        for (int x = 0; x < kPixels; ++x)
            most = std::max(most, std::abs(other.at(x, kPixels / 2, 0) - plain.at(x, kPixels / 2, 0)) / 3.0f);
        return most;
    };
    const float path = farthest(irradiance({.technique = "six_gaussians", .path = "light_pre_pass"}));
    const float half = farthest(irradiance({.technique = "six_gaussians", .mesh = "half.obj"}));
    const float size = farthest(irradiance({.technique = "six_gaussians", .map_size = 256}));
    const float colour = farthest(irradiance({.technique = "six_gaussians", .pre_scatter = 0.5f}));
    const float power = farthest(irradiance({.technique = "six_gaussians", .pre_scatter = 0.7f}));
    // the gobo stays where it is: so does the edge
    const float moved = farthest(irradiance({.technique = "six_gaussians", .moved_m = 0.004f}));
    std::printf(
        "largest change of red irradiance: other path %.5f, half the UVs %.5f, half the map %.5f, colour "
        "before %.5f and %.5f, sheet moved %.5f\n",
        double(path), double(half), double(size), double(colour), double(power), double(moved));
    EXPECT_LT(path, 1e-5f);
    EXPECT_LT(half, 0.05f);
    EXPECT_LT(size, 0.05f);
    EXPECT_LT(colour, 1e-3f);
    EXPECT_LT(power, 1e-3f);
    EXPECT_LT(moved, 0.05f);
}

TEST_F(SkinTextureSpaceTest, AsMuchEntersAsInTheLightPass) {
    const auto lit = [&](const char* technique) {
        return irradiance({.technique = technique}).at(kPixels - 1, kPixels / 2, 2);
    };
    const float lambert = lit("lambert"), six = lit("six_gaussians"), hable = lit("hable");
    std::printf("irradiance far from the edge, blue: lambert %.4f, six_gaussians %.4f, hable %.4f lux\n",
                double(lambert), double(six), double(hable));
    EXPECT_NEAR(six / lambert, 1.0f, 2e-3f);
    EXPECT_NEAR(hable / lambert, 1.0f, 2e-3f);
}

TEST_F(SkinTextureSpaceTest, ColourSpreadsAsLightDoes) {
    // evenly lit, dark and bright halves: all of the colour counts where light enters
    const Look look{.technique = "lambert", .pre_scatter = 1.0f, .colour = "two.png", .slide = ""};
    const Image base = irradiance(look, "gbuffer_base");
    const physics::DiffusionProfile skin = physics::six_gaussian_skin();
    const float pixel = 2.0f * look.distance_m * std::tan(0.5f * 10.0f * 0.0174533f) / float(kPixels);
    const int row = kPixels / 2;
    for (const auto& [technique, most] : {std::pair("six_gaussians", 0.01f), std::pair("separable", 0.02f),
                                          std::pair("disc", 0.02f), std::pair("two_gaussians", 0.1f)}) {
        Look other = look;
        other.technique = technique;
        const Image light = irradiance(other);
        other.path = "light_pre_pass";
        const Image second = irradiance(other);
        glm::vec3 sum(0.0f);
        float paths = 0.0f;
        for (int x = 0; x < kPixels; ++x) {
            const glm::vec3 edge = skin.edge((float(x) + 0.5f - 0.5f * kPixels) * pixel);
            for (int c = 0; c < 3; ++c) {
                const float dark = base.at(0, row, c), bright = base.at(kPixels - 1, row, c);
                const float wanted = light.at(kPixels - 1, row, c) * glm::mix(dark, bright, edge[c]);
                const float error = (light.at(x, row, c) * base.at(x, row, c) - wanted) / (3.0f * bright);
                sum[c] += error * error / float(kPixels);
                // the G-buffer keeps colour in 16 bits
                paths = std::max(paths, base.at(x, row, c) * std::abs(light.at(x, row, c) - second.at(x, row, c)));
            }
        }
        const glm::vec3 rms = glm::sqrt(sum);
        std::printf("colour spread by %s: RMS %.4f %.4f %.4f; the other path is %.6f away\n", technique, double(rms.x),
                    double(rms.y), double(rms.z), double(paths));
        EXPECT_LT(std::max({rms.x, rms.y, rms.z}), most);
        EXPECT_LT(paths, 1e-4f);
    }
}

TEST_F(SkinTextureSpaceTest, ACheckerOnTheScreenIsAsInTheMap) {
    const auto seen = [&](const char* technique, const char* path, float pre_scatter) {
        return irradiance({.technique = technique, .path = path, .pre_scatter = pre_scatter, .colour = "checker.png"},
                          "radiance");
    };
    const Image map = seen("six_gaussians", "deferred", 0.7f);
    const auto flip = [&](const Image& a, const Image& b) { return double(compare_flip(a, b).mean); };
    const double unspread = flip(map, seen("separable", "deferred", 0.0f));
    std::printf("colour that does not spread: FLIP %.4f off the map\n", unspread);
    // a checker's waves lie at 45 degrees to separable's lines, where they are farthest from round; two_gaussians has
    // another profile in green and blue
    for (const auto& [technique, most] :
         {std::pair("separable", 0.045), std::pair("disc", 0.02), std::pair("two_gaussians", 0.095)}) {
        const Image screen = seen(technique, "deferred", 0.7f);
        const double off = flip(map, screen), path = flip(screen, seen(technique, "light_pre_pass", 0.7f));
        std::printf("%s: FLIP %.4f off the map, %.4f between both paths\n", technique, off, path);
        EXPECT_LT(off, std::min(most, unspread));
        EXPECT_LT(path, 0.01);
    }
}

TEST_F(SkinTextureSpaceTest, WhatHasNoMapIsStillLit) {
    const Image tiled = irradiance({.technique = "six_gaussians", .mesh = "tiled.obj"});
    EXPECT_GT(tiled.at(kPixels - 1, kPixels / 2, 0), 1.0f);
    EXPECT_LT(tiled.at(0, kPixels / 2, 0), 0.1f);
}

}  // namespace
}  // namespace tyndall::skin
