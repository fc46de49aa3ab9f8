// The techniques tsm, thickness and wrap: what they are made of, and that light ends without belts.

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <numbers>

#include "app/engine.h"
#include "body_size.h"
#include "light_view.h"
#include "radial_kernel.h"
#include "renderer_fixture.h"
#include "scene/primitives.h"
#include "thickness/thickness_grid.h"
#include "tsm/level_kernels.h"
#include "wrap/wrap_amount.h"

namespace tyndall::translucency {
namespace {

const Optics kPotato{{680, 700, 550}, {2.4f, 9.0f, 120.0f}, 1.3f};
const Optics kMarble{{2190, 2620, 3000}, {2.1f, 4.1f, 7.1f}, 1.5f};

Mesh sheet(float thickness) {
    Mesh mesh = make_primitive(Primitive::box, 3);
    for (glm::vec3& p : mesh.positions) p *= glm::vec3(1.0f, thickness, 1.0f);
    mesh.bounds = bounds_of(mesh.positions);
    return mesh;
}

Light light_at(const glm::vec3& place, const glm::vec3& travel, LightKind kind) {
    Light light;
    light.kind = kind;
    const glm::vec3 back = -glm::normalize(travel), right = glm::normalize(glm::cross(glm::vec3(0, 1, 0), back));
    light.transform = glm::mat4(glm::mat3(right, glm::cross(back, right), back));
    light.transform[3] = glm::vec4(place, 1.0f);
    return light;
}

TEST(LightView, HoldsTheObject) {
    const Mesh mesh = make_primitive(Primitive::cylinder, 32);
    glm::mat4 transform(glm::mat3(0.1f, 0.02f, 0.0f, -0.03f, 0.2f, 0.05f, 0.01f, 0.0f, 0.1f));
    transform[3] = glm::vec4(3, 1, 2, 1);
    for (const LightKind kind : {LightKind::directional, LightKind::spot, LightKind::point}) {
        const Light light = light_at({3.5f, 2.0f, 2.2f}, {-0.5f, -1.0f, -0.2f}, kind);
        const LightView view = light_view(light, mesh, transform, 64);
        ASSERT_TRUE(view.whole);
        glm::vec3 low(2.0f), high(-2.0f);
        for (const glm::vec3& p : mesh.positions) {
            const glm::vec4 world = transform * glm::vec4(p, 1.0f), clip = view.clip_from_world * world;
            const glm::vec3 at(view.view_from_world * world);
            const float k = view.perspective ? at.z : 1.0f;
            const glm::vec2 window = 2.0f * (glm::vec2(at) / k - view.low) / view.size - 1.0f;
            EXPECT_LT(glm::distance(window, glm::vec2(clip) / clip.w), 1e-4f) << "the window is what is drawn";
            low = glm::min(low, glm::vec3(clip) / clip.w);
            high = glm::max(high, glm::vec3(clip) / clip.w);
        }
        EXPECT_GT(std::min(low.x, low.y), -1.0f);
        EXPECT_LT(std::max(high.x, high.y), 1.0f);
        EXPECT_GT(low.z, 0.0f);
        EXPECT_LT(high.z, 1.0f);
        EXPECT_NEAR(std::max(high.x - low.x, high.y - low.y), 2.0f * 60.0f / 64.0f, 1e-3f) << "no larger than needed";
    }
}

TEST(LightView, NotWholeFromInside) {
    const Mesh mesh = make_primitive(Primitive::sphere, 16);
    EXPECT_FALSE(light_view(light_at({0, 0, 0.3f}, {0.1f, 0, -1}, LightKind::point), mesh, glm::mat4(1.0f), 64).whole);
    EXPECT_FALSE(light_view(light_at({0, 0, 3}, {0.1f, 0, -1}, LightKind::spot), mesh, glm::mat4(0.0f), 64).whole);
    EXPECT_FALSE(light_view(light_at({0, 0, 3}, {0.1f, 0, -1}, LightKind::spot), Mesh{}, glm::mat4(1.0f), 64).whole);
}

TEST(LightView, ALampInsideStillSeesSomething) {
    const Mesh mesh = make_primitive(Primitive::sphere, 16);
    for (const glm::vec3 place : {glm::vec3(0.0f), glm::vec3(0.1f, 0.0f, 0.0f)}) {
        const LightView view = light_view(light_at(place, {0, 0, -1}, LightKind::point), mesh, glm::mat4(1.0f), 256);
        EXPECT_FALSE(view.whole);
        EXPECT_GT(view.size, 0.0f);
        EXPECT_LT(std::atan(0.5f * view.size), 76.0f * std::numbers::pi_v<float> / 180.0f);
        EXPECT_TRUE(std::isfinite(view.clip_from_world[3].z));
    }
}

// The cells that gather.comp looks at, on flat ground under even light.
TEST(LevelKernels, CellsAddUpToAllTheLight) {
    for (const Optics& optics : {kPotato, kMarble}) {
        const float texel = 0.25f / 700.0f;
        const LevelKernels made =
            make_level_kernels({optics, Model::photon_beams, Scaling::exact, texel, 9, 0.3f, glm::vec3(1.0f)});
        glm::dvec3 sum(0.0);
        for (int level = 0; level < 9; ++level)
            for (int j = 0; j < 4; ++j)
                for (int i = 0; i < 4; ++i) {
                    if (level > 0 && i % 3 != 0 && j % 3 != 0) continue;
                    const double cell = std::ldexp(double(texel), level), r = cell * std::hypot(i - 1.5, j - 1.5);
                    const double column = std::sqrt(r / 0.3) * (LevelKernels::kColumns - 1);
                    const size_t at = size_t(level) * LevelKernels::kColumns + size_t(column);
                    const glm::dvec4 value = glm::mix(glm::dvec4(made.table[at]), glm::dvec4(made.table[at + 1]),
                                                      column - std::floor(column));
                    EXPECT_GE(std::min({value.x, value.y, value.z}), 0.0);
                    sum += cell * cell * glm::dvec3(value);
                }
        std::printf("cells: %.4f %.4f %.4f of the light\n", sum.x, sum.y, sum.z);
        for (int c = 0; c < 3; ++c) {
            EXPECT_NEAR(sum[c], 1.0, 0.05);
            EXPECT_GT(made.own_share[c], 0.0f);
            EXPECT_LT(made.own_share[c], 1.0f);
        }
    }
}

TEST(SurfaceDensity, OfASphereEndsAtItsDiameter) {
    const glm::mat3 size(0.02f);
    const Mesh ball = make_primitive(Primitive::sphere, 128);
    EXPECT_NEAR(body_radius(ball, size), 0.01f, 1e-4f);
    const SurfaceDensity density(ball, size);
    for (const Optics& optics : {kPotato, kMarble}) {
        const RadialKernel kernel(optics, Model::photon_beams, Scaling::exact, 1e-3f);
        const glm::vec3 found = density.sent_out(kernel), exact = kernel.share_within(0.02f);
        std::printf("sphere: %.4f %.4f %.4f, exactly %.4f %.4f %.4f\n", double(found.x), double(found.y),
                    double(found.z), double(exact.x), double(exact.y), double(exact.z));
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(found[c], exact[c], 0.02f);
    }
}

TEST(SurfaceDensity, ASheetHasAnotherSide) {
    const float thickness = 0.02f;  // of a metre
    const RadialKernel kernel(kMarble, Model::photon_beams, Scaling::exact, 1e-3f);
    const glm::vec3 found = SurfaceDensity(sheet(thickness), glm::mat3(0.1f)).sent_out(kernel);
    const glm::vec3 exact = 2.0f - kernel.share_within(0.1f * thickness);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(found[c], exact[c], 0.05f);
}

TEST(Wrap, KeepsTheMeanAndTheFirstMoment) {
    for (const Optics& optics : {kPotato, kMarble})
        for (const float radius : {0.001f, 0.01f, 0.1f}) {
            const WrapAmount amount = wrap_amount(optics, Model::photon_beams, radius);
            const RadialKernel kernel(optics, Model::photon_beams, Scaling::exact, radius);
            for (int c = 0; c < 3; ++c) {
                double mean = 0.0, first = 0.0, square = 0.0;
                constexpr int kSteps = 2000;
                for (int i = 0; i < kSteps; ++i) {
                    const float cosine = (2.0f * (float(i) + 0.5f) / kSteps) - 1.0f;
                    const float narrow = wrapped(cosine, amount.a), wide = wrapped(cosine, 1.0f);
                    const double value =
                        double(narrow + amount.wide[c] * (wide - narrow) + amount.even[c] * (0.25f - narrow));
                    EXPECT_GE(value, -1e-6);
                    mean += value / kSteps;
                    first += value * double(cosine) * 2.0 / kSteps;
                }
                for (int i = 0; i < kSteps; ++i) {
                    const float middle = 2.0f * radius * (float(i) + 0.5f) / kSteps, half = radius / kSteps;
                    square += double((kernel.share_within(middle + half) - kernel.share_within(middle - half))[c]) *
                              std::pow(double(middle / radius), 2);
                }
                const double kept = 1.0 - 0.5 * square / double(kernel.share_within(2.0f * radius)[c]);
                EXPECT_NEAR(mean, 0.25, 1e-3);
                EXPECT_NEAR(3.0 * first, kept, 0.01) << "radius " << radius;
            }
        }
}

TEST(ThicknessGrid, IsASlabsOwnAndABallsRadius) {
    const auto mean = [](const Mesh& mesh) { return make_thickness_grid(mesh, 32).mean; };
    const float ball = mean(make_primitive(Primitive::sphere, 128)), slab = mean(sheet(0.05f));
    std::printf("ball of diameter 1: %.4f, sheet of 0.05: %.4f\n", double(ball), double(slab));
    EXPECT_NEAR(ball, 0.5f, 0.01f);
    EXPECT_NEAR(slab, 0.05f, 0.005f) << "its narrow sides are thicker";
    EXPECT_TRUE(make_thickness_grid(Mesh{}, 32).empty());
}

class BeltTest : public RendererTest {
 protected:
    static constexpr int kSize = 256;

    /// Radiance along a ring on a ball where the eye looks at one angle, from the middle of the lit side to that of the
    /// shaded.
    std::vector<float> profile(const std::string& technique, const std::string& preset) {
        const std::filesystem::path file =
            std::filesystem::temp_directory_path() / ("tyndall_belt_" + std::to_string(getpid()) + ".json");
        std::ofstream(file)
            << R"({"tyndall": 1, "modules": ["translucency"], "render": {"image": {"antialiasing": "none"}},
          "entities": [
          {"name": "Camera", "transform": {"translation": [0, 0, 0.6], "look_at": [0, 0, 0]},
           "camera": {"vertical_fov_deg": 2.2, "exposure": 1, "near_m": 0.001}},
          {"name": "Sun", "transform": {"translation": [1, 0, 0], "look_at": [0, 0, 0]},
           "directional_light": {"illuminance_lux": 3, "shadow": {"size": 1024, "cascades": 1, "distance_m": 1}}},
          {"name": "Ball", "transform": {"scale": 0.02}, "mesh": {"primitive": "sphere", "tessellation": 256},
           "material": {"roughness": 1, "specular": 0}, "interior": {"ior": 1, "preset": ")"
            << preset << R"(", "technique": ")" << technique << R"("}}]})";
        Engine engine(true);
        engine.load_scene(file, {});
        std::filesystem::remove(file);
        engine.renderer().retain({"radiance"});
        engine.renderer().render(engine.extract(), {kSize, kSize});
        EXPECT_EQ(engine.problems(), "");
        const Image image = picture(*engine.renderer().target("radiance"));
        std::vector<float> values;
        const float ring = 0.8f * 0.01f / (0.6f * std::tan(1.1f * std::numbers::pi_v<float> / 180.0f)) * kSize / 2.0f;
        for (float angle = 0.0f; angle <= std::numbers::pi_v<float>; angle += 0.04f) {
            const float x = 0.5f * kSize + ring * std::cos(angle) - 0.5f,
                        y = 0.5f * kSize - ring * std::sin(angle) - 0.5f;
            const int i = int(x), j = int(y);
            const float u = x - float(i), v = y - float(j);
            values.push_back(std::lerp(std::lerp(image.at(i, j, 0), image.at(i + 1, j, 0), u),
                                       std::lerp(image.at(i, j + 1, 0), image.at(i + 1, j + 1, 0), u), v));
        }
        return values;
    }
};

TEST_F(BeltTest, LightEndsWithoutBelts) {
    for (const char* technique : {"tsm", "thickness", "wrap"})
        for (const char* preset : {"marble", "potato"}) {
            const std::vector<float> values = profile(technique, preset);
            float rise = 0.0f;
            for (size_t i = 1; i < values.size(); ++i) rise = std::max(rise, values[i] - values[i - 1]);
            std::printf("%s, %s: from %.4f to %.4f, steepest rise %.5f\n", technique, preset, double(values.front()),
                        double(values.back()), double(rise));
            EXPECT_GT(values.front(), 0.3f);
            EXPECT_LT(values.back(), 0.5f * values.front());
            EXPECT_LT(rise, 0.004f * values.front());
        }
}

}  // namespace
}  // namespace tyndall::translucency
