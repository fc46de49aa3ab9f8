// Techniques of skin on the screen: a flat sheet lit to a knife edge and through a slit, against the profile's exact
// convolution of what arrives.

#include <gtest/gtest.h>
#include <unistd.h>

#include <fmt/format.h>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <utility>

#include "app/engine.h"
#include "image/image_io.h"
#include "kernel.h"
#include "renderer_fixture.h"

namespace tyndall::skin {
namespace {

constexpr float kDegree = std::numbers::pi_v<float> / 180.0f;

/// Where the picture is taken from and how.
struct Look {
    float distance_m = 0.3f;
    float fov_deg = 10.0f;
    int size = 128;
    float turned_deg = 0.0f;  ///< the edge, about the eye's axis
    float tilted_deg = 0.0f;  ///< the sheet, about the edge's direction

    [[nodiscard]] float pixel_m() const { return 2.0f * distance_m * std::tan(0.5f * fov_deg * kDegree) / float(size); }
};

class SkinScreenTest : public RendererTest {
 protected:
    void SetUp() override {
        RendererTest::SetUp();
        folder_ = std::filesystem::temp_directory_path() / ("tyndall_skin_" + std::to_string(getpid()));
        std::filesystem::create_directories(folder_);
        // over 40 mm: half, and a slit of 1 mm
        save_mask("edge.png", [](int x) { return x >= 512; });
        save_mask("slit.png", [](int x) { return std::abs(x - 512) <= 13; });
    }
    void TearDown() override {
        std::filesystem::remove_all(folder_);
        RendererTest::TearDown();
    }

    template <class Lit>
    void save_mask(const char* name, const Lit& lit) {
        Image mask(1024, 4, 1, Image::Type::u8);
        for (int y = 0; y < 4; ++y)
            for (int x = 0; x < 1024; ++x) mask.bytes()[size_t(y * 1024 + x)] = lit(x) ? 255 : 0;
        save_png(folder_ / name, mask);
    }

    /// Irradiance as the compose pass gets it.
    Image irradiance(const std::string& technique, const std::string& mask, const Look& look) {
        const std::filesystem::path file = folder_ / "scene.json";
        const float z = std::sin(0.5f * look.turned_deg * kDegree), w = std::cos(0.5f * look.turned_deg * kDegree);
        const glm::quat turned(w, 0, 0, z);
        const glm::quat tilted(std::cos(0.5f * look.tilted_deg * kDegree), 0,
                               std::sin(0.5f * look.tilted_deg * kDegree), 0);
        const glm::quat both = turned * tilted;
        std::ofstream(file) << fmt::format(
            R"({{"tyndall": 1, "modules": ["skin"], "render": {{"image": {{"antialiasing": "none"}}}},
          "entities": [
          {{"name": "Camera", "transform": {{"translation": [0, 0, {}], "look_at": [0, 0, 0]}},
           "camera": {{"vertical_fov_deg": {}, "exposure": 1, "near_m": 0.001}}}},
          {{"name": "Sun", "transform": {{"rotation": [{}, {}, {}, {}]}},
           "directional_light": {{"illuminance_lux": 3, "gobo": "{}", "gobo_size_m": [0.04, 10]}}}},
          {{"name": "Sheet", "transform": {{"translation": [0, 0, 0], "rotation": [{}, {}, {}, {}], "scale": [4, 4, 0.000001]}},
           "mesh": {{"primitive": "box"}}, "material": {{"roughness": 1}},
           "skin": {{"technique": "{}", "pre_scatter": 0, "transmission": 0}}}}]}})",
            look.distance_m, look.fov_deg, both.x, both.y, both.z, both.w, mask, both.x, both.y, both.z, both.w,
            technique);
        Engine engine(true);
        engine.load_scene(file, {});
        engine.renderer().retain({"light_diffuse"});
        engine.renderer().render(engine.extract(), {look.size, look.size});
        EXPECT_EQ(engine.problems(), "");
        return picture(*engine.renderer().target("light_diffuse"));
    }

    std::filesystem::path folder_;
};

/// What the profile makes of a picture of a sheet across the line of sight: each pixel's light over the pixels around.
Image convolved(const Image& image, const physics::DiffusionProfile& profile, float pixel_m) {
    Image result(image.width, image.height, 3, Image::Type::f32);
    const int reach_pixels = int(std::ceil(reach(profile) / pixel_m)) + 2;
    // a Gaussian over square pixels is a product
    for (const physics::DiffusionLobe& lobe : profile.lobes) {
        std::vector<float> line(size_t(reach_pixels) + 1);
        const physics::DiffusionProfile one{{{lobe.variance_m2, glm::vec3(1.0f)}}};
        for (int i = 0; i <= reach_pixels; ++i)
            line[size_t(i)] = one.edge((float(i) + 0.5f) * pixel_m).x - one.edge((float(i) - 0.5f) * pixel_m).x;
        const auto blurred = [&](const Image& from, glm::ivec2 step) {
            Image to(from.width, from.height, 3, Image::Type::f32);
            for (int y = 0; y < from.height; ++y)
                for (int x = 0; x < from.width; ++x)
                    for (int i = -reach_pixels; i <= reach_pixels; ++i) {
                        const int u = std::clamp(x + i * step.x, 0, from.width - 1);
                        const int v = std::clamp(y + i * step.y, 0, from.height - 1);
                        for (int c = 0; c < 3; ++c) to.at(x, y, c) += line[size_t(std::abs(i))] * from.at(u, v, c);
                    }
            return to;
        };
        const Image wide = blurred(blurred(image, {1, 0}), {0, 1});
        for (int y = 0; y < image.height; ++y)
            for (int x = 0; x < image.width; ++x)
                for (int c = 0; c < 3; ++c) result.at(x, y, c) += lobe.weight[c] * wide.at(x, y, c);
    }
    return result;
}

/// RMS of the difference over the middle of the picture, over the largest value of `scale`, a channel each.
glm::vec3 rms(const Image& a, const Image& b, const Image& scale) {
    glm::vec3 sum(0.0f), most(0.0f);
    int count = 0;
    for (int y = a.height / 4; y < a.height * 3 / 4; ++y)
        for (int x = a.width / 4; x < a.width * 3 / 4; ++x, ++count)
            for (int c = 0; c < 3; ++c) {
                sum[c] += (a.at(x, y, c) - b.at(x, y, c)) * (a.at(x, y, c) - b.at(x, y, c));
                most[c] = std::max(most[c], scale.at(x, y, c));
            }
    return glm::sqrt(sum / float(count)) / most;
}

/// Metres from a tenth to nine tenths of the light along the middle row.
float width(const Image& image, int channel, float pixel_m) {
    const int y = image.height / 2;
    const float most = image.at(image.width - 2, y, channel), least = image.at(1, y, channel);
    const auto crossing = [&](float share) {
        for (int x = 1; x < image.width; ++x) {
            const float a = (image.at(x - 1, y, channel) - least) / (most - least);
            const float b = (image.at(x, y, channel) - least) / (most - least);
            if (a < share && b >= share) return float(x - 1) + (share - a) / (b - a);
        }
        return 0.0f;
    };
    return pixel_m * (crossing(0.9f) - crossing(0.1f));
}

TEST_F(SkinScreenTest, EdgesAndSlitsAreTheProfiles) {
    const physics::DiffusionProfile skin = physics::six_gaussian_skin();
    struct Case {
        const char* technique;
        float most;  ///< of the RMS
    };
    for (const char* mask : {"edge.png", "slit.png"})
        for (const float turned : {0.0f, 90.0f, 30.0f}) {
            const Look look{.turned_deg = turned};
            const Image arrives = irradiance("lambert", mask, look);
            const Image exact = convolved(arrives, skin, look.pixel_m());
            for (const Case& c : {Case{"separable", 0.02f}, Case{"disc", 0.02f}, Case{"two_gaussians", 1.0f}}) {
                const glm::vec3 error = rms(irradiance(c.technique, mask, look), exact, arrives);
                std::printf("%s at %.0f degrees, %s: RMS %.4f %.4f %.4f\n", mask, double(turned), c.technique,
                            double(error.x), double(error.y), double(error.z));
                EXPECT_LT(std::max({error.x, error.y, error.z}), c.most);
            }
        }
}

TEST_F(SkinScreenTest, WidthsAreMillimetresOfTheWorld) {
    const physics::DiffusionProfile skin = physics::six_gaussian_skin();
    const Look looks[] = {{.distance_m = 0.15f},
                          {.distance_m = 0.3f},
                          {.distance_m = 0.6f},
                          {.distance_m = 0.3f, .size = 240},
                          {.distance_m = 0.3f, .fov_deg = 30.0f, .size = 240}};
    for (const Look& look : looks) {
        const Image exact = convolved(irradiance("lambert", "edge.png", look), skin, look.pixel_m());
        const float wanted = width(exact, 0, look.pixel_m());
        for (const auto& [technique, most] : {std::pair("separable", 0.03f), std::pair("disc", 0.03f)}) {
            const float is = width(irradiance(technique, "edge.png", look), 0, look.pixel_m());
            std::printf("%s from %.2f m, %.0f degrees, %d pixels (%.2f mm): %.3f mm, should be %.3f\n", technique,
                        double(look.distance_m), double(look.fov_deg), look.size, double(1000 * look.pixel_m()),
                        double(1000 * is), double(1000 * wanted));
            EXPECT_NEAR(is, wanted, most * wanted);
        }
    }
}

/// A ball half lit.
class SkinBallTest : public SkinScreenTest {
 protected:
    void load(Engine& engine, const std::string& technique) const {
        const std::filesystem::path file = folder_ / "ball.json";
        std::ofstream(file) << fmt::format(
            R"({{"tyndall": 1, "modules": ["skin"], "render": {{"image": {{"antialiasing": "none"}}}}, "entities": [
          {{"name": "Camera", "camera": {{"vertical_fov_deg": 20, "exposure": 1, "near_m": 0.001}}}},
          {{"name": "Sun", "transform": {{"translation": [1, 0.3, 0.2], "look_at": [0, 0, 0]}},
           "directional_light": {{"illuminance_lux": 3}}}},
          {{"name": "Ball", "transform": {{"scale": 0.05}}, "mesh": {{"primitive": "sphere"}},
           "skin": {{"technique": "{}", "transmission": 0}}}}]}})",
            technique);
        engine.load_scene(file, {});
        engine.renderer().retain({"light_diffuse"});
    }
    /// Irradiance, seen along the z axis from so far to the right.
    static Image seen(Engine& engine, float right_m) {
        View view;
        view.camera[3] = {right_m, 0.0f, 0.2f, 1.0f};
        engine.frame(0.0, {128, 128}, view);
        EXPECT_EQ(engine.problems(), "");
        return picture(*engine.renderer().target("light_diffuse"));
    }
    static double sum(const Image& image) {
        double total = 0.0;
        for (int y = 0; y < image.height; ++y)
            for (int x = 0; x < image.width; ++x)
                for (int c = 0; c < 3; ++c) total += double(image.at(x, y, c));
        return total;
    }
};

TEST_F(SkinBallTest, NothingOfAnotherViewIsSeen) {
    for (const char* technique : {"two_gaussians", "separable", "disc"}) {
        Engine first(true), second(true);
        load(first, technique);
        load(second, technique);
        const Image fresh = seen(first, 0.0f);
        (void)seen(second, -0.004f);
        const Image after = seen(second, 0.0f);
        float largest = 0.0f;
        for (int y = 0; y < fresh.height; ++y)
            for (int x = 0; x < fresh.width; ++x)
                largest = std::max(largest, std::abs(after.at(x, y, 0) - fresh.at(x, y, 0)));
        std::printf("%s: largest difference after another view %g\n", technique, double(largest));
        EXPECT_LT(largest, 1e-5f) << technique;
    }
}

TEST_F(SkinBallTest, AsMuchLightLeavesAsArrives) {
    Engine engine(true);
    load(engine, "lambert");
    const double arrives = sum(seen(engine, 0.0f));
    for (const char* technique : {"two_gaussians", "separable", "disc"}) {
        load(engine, technique);
        const double leaves = sum(seen(engine, 0.0f)) / arrives;
        std::printf("%s: %.4f of the light that arrives\n", technique, leaves);
        EXPECT_NEAR(leaves, 1.0, 0.02) << technique;
    }
}

/// A white sheet under many suns of one radiance from everywhere.
class SkinFurnaceTest : public SkinScreenTest {
 protected:
    /// Radiance of the sheet where the eye sees it at an angle to its normal, over the suns'.
    float radiance(float angle_deg, float roughness, const std::string& specular) {
        constexpr int kSuns = 500;
        std::string suns;
        for (int i = 0; i < kSuns; ++i) {
            const float z = (float(i) + 0.5f) / kSuns, r = std::sqrt(1.0f - z * z), turn = 2.39996323f * float(i);
            suns += fmt::format(
                R"({{"transform": {{"translation": [{}, {}, {}], "look_at": [0, 0, 0]}}, "directional_light": {{"illuminance_lux": {}}}}},)",
                r * std::cos(turn), r * std::sin(turn), z, 2.0f * std::numbers::pi_v<float> / kSuns);
        }
        const std::filesystem::path file = folder_ / "furnace.json";
        std::ofstream(file) << fmt::format(
            R"({{"tyndall": 1, "modules": ["skin"], "render": {{"image": {{"antialiasing": "none"}}}}, "entities": [{}
          {{"name": "Camera", "transform": {{"translation": [{}, 0, {}], "look_at": [0, 0, 0]}},
           "camera": {{"vertical_fov_deg": 1, "exposure": 1, "near_m": 0.001}}}},
          {{"name": "Sheet", "transform": {{"scale": [4, 4, 0.000001]}}, "mesh": {{"primitive": "box"}},
           "material": {{"base_colour": [1, 1, 1], "roughness": {}}}, "skin": {{"specular": "{}"}}}}]}})",
            suns, std::sin(angle_deg * kDegree), std::cos(angle_deg * kDegree), roughness, specular);
        Engine engine(true);
        engine.load_scene(file, {});
        engine.renderer().retain({"radiance"});
        engine.renderer().render(engine.extract(), {8, 8});
        EXPECT_EQ(engine.problems(), "");
        return centre(picture(*engine.renderer().target("radiance"))).x;
    }
};

TEST_F(SkinFurnaceTest, WhiteSkinGivesBackWhatComes) {
    for (const char* specular : {"two_lobes", "kelemen"})
        for (const float roughness : {0.35f, 0.5f, 0.7f})
            for (const float angle : {0.0f, 45.0f, 70.0f}) {
                const float light = radiance(angle, roughness, specular);
                std::printf("%s, roughness %.2f, %.0f degrees: %.4f\n", specular, double(roughness), double(angle),
                            double(light));
                EXPECT_LE(light, 1.005f) << "500 suns are not quite even";
                EXPECT_GE(light, 0.95f);
            }
}

}  // namespace
}  // namespace tyndall::skin
