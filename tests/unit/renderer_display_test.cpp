// From radiance to the display.

#include "core/error.h"
#include "physics/physics.h"
#include "renderer_fixture.h"

namespace tyndall {
namespace {

/// A sky whose colours run over fourteen stops.
RenderScene ramp() {
    RenderScene scene;
    scene.sky.radiance = glm::vec3(1.0f);
    scene.sky.image =
        test::probe_image(256, [](glm::vec3 d) { return glm::exp2(7.0f * d) * glm::vec3(1.0f, 0.8f, 1.2f); });
    scene.camera.vertical_fov = 2.0f;
    scene.camera.exposure = 0.6f;
    return scene;
}

/// Largest difference between what OpenColorIO's CPU makes of the radiance and the picture.
float difference(const ColorConfig& color, const std::string& display, const std::string& view, Image radiance,
                 const Image& shown, float exposure) {
    for (float& value : radiance.floats()) value *= exposure;
    color.apply_display(radiance.floats(), display, view);
    float worst = 0.0f;
    for (size_t i = 0; i < radiance.value_count(); ++i)
        worst = std::max(worst, std::abs(std::clamp(radiance.floats()[i], 0.0f, 1.0f) - shown.floats()[i]));
    return worst;
}

using RendererDisplay = RendererTest;

TEST_F(RendererDisplay, EveryViewEqualsTheCpu) {
    const RenderScene scene = ramp();
    int views = 0;
    for (const std::string& display : color_.displays())
        for (const std::string& view : color_.views(display)) {
            renderer_->set_display(display, view);
            renderer_->retain({"radiance", "encoded"});
            renderer_->render(scene, {160, 90});
            const float worst = difference(color_, display, view, picture(*renderer_->target("radiance")),
                                           picture(*renderer_->target("encoded")), 0.6f);
            std::printf("%s / %s: largest difference to the CPU %.2g\n", display.c_str(), view.c_str(), worst);
            EXPECT_LE(worst, 1e-3f) << display << " " << view;
            ++views;
        }
    EXPECT_GE(views, 2);
}

TEST_F(RendererDisplay, ExposureIsThatOfTheCamera) {
    RenderScene scene = ramp();
    settings_->get<ImageSettings>().antialiasing = Antialiasing::none;
    settings_->get<ImageSettings>().dither = false;
    scene.camera.exposure.reset();
    scene.camera.ev100 = 2.0f;
    const Image radiance = render(scene, {160, 90});
    const Image shown = render(scene, {160, 90}, "display");
    EXPECT_LE(difference(color_, {}, {}, radiance, shown, 1.0f / 4.8f), 0.5f / 255.0f + 1e-3f);
    scene.camera.exposure = 0.1f;  // wins over ev100
    EXPECT_LE(difference(color_, {}, {}, radiance, render(scene, {160, 90}, "display"), 0.1f), 0.5f / 255.0f + 1e-3f);
}

TEST_F(RendererDisplay, DitherIsOneStepAndKeepsTheMean) {
    RenderScene scene;
    settings_->get<ImageSettings>().antialiasing = Antialiasing::none;
    scene.camera.exposure = 1.0f;
    scene.sky.radiance = glm::vec3(0.2f);
    settings_->get<ImageSettings>().dither = false;
    std::vector<float> exact{0.2f, 0.2f, 0.2f};
    color_.apply_display(exact);
    const Image plain = render(scene, {64, 64}, "display");
    for (const float value : plain.floats()) ASSERT_NEAR(value, exact[0], 0.5f / 255.0f + 1e-4f);
    settings_->get<ImageSettings>().dither = true;
    for (const uint64_t frame : {0u, 1u, 500u}) {
        scene.frame = frame;
        double sum = 0.0;
        const Image image = render(scene, {64, 64}, "display");
        for (const float value : image.floats()) {
            ASSERT_NEAR(value, exact[0], 1.51f / 255.0f);
            sum += double(value);
        }
        EXPECT_NEAR(sum / double(image.value_count()), double(exact[0]), 0.05 / 255.0);
    }
    scene.sky.radiance = glm::vec3(0.0f);
    const Image black = render(scene, {64, 64}, "display");
    for (const float value : black.floats()) ASSERT_EQ(value, 0.0f);
}

/// The size of steps between neighbours along the edge of a bright sphere.
float roughness_of_edges(const Image& image) {
    float sum = 0.0f;
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x + 1 < image.width; ++x) sum += std::pow(image.at(x + 1, y, 0) - image.at(x, y, 0), 2.0f);
    return sum;
}

TEST_F(RendererDisplay, AntialiasingSoftensEdgesAndNothingElse) {
    RenderScene scene;
    const auto glowing = test::material(glm::vec3(0.0f), 0.0f, 1.0f);
    glowing->emissive = glm::vec3(1.0f);
    test::add(scene, test::sphere_mesh(), glowing, test::translated({0, 0, -4}));
    scene.camera.exposure = 1.0f;
    settings_->get<ImageSettings>().dither = false;
    settings_->get<ImageSettings>().antialiasing = Antialiasing::none;
    const Image rough = render(scene, {160, 90}, "display");
    settings_->get<ImageSettings>().antialiasing = Antialiasing::fxaa;
    const Image smooth = render(scene, {160, 90}, "display");
    EXPECT_LT(roughness_of_edges(smooth), 0.8f * roughness_of_edges(rough));
    int changed = 0;
    for (int y = 1; y + 1 < rough.height; ++y)
        for (int x = 1; x + 1 < rough.width; ++x) {
            if (std::abs(rough.at(x, y, 0) - smooth.at(x, y, 0)) < 2.0f / 255.0f) continue;
            ++changed;
            const float here = rough.at(x, y, 0);
            const bool edge = rough.at(x - 1, y, 0) != here || rough.at(x + 1, y, 0) != here ||
                              rough.at(x, y - 1, 0) != here || rough.at(x, y + 1, 0) != here;
            ASSERT_TRUE(edge) << x << " " << y;
        }
    EXPECT_GT(changed, 50);
}

TEST_F(RendererDisplay, AnUnknownViewKeepsTheLastGoodOne) {
    const RenderScene scene = ramp();
    renderer_->set_display({}, color_.views().back());
    const Image before = render(scene, {32, 18}, "display");
    EXPECT_THROW(renderer_->set_display({}, "no such view"), Error);
    EXPECT_THROW(renderer_->set_display("no such display", {}), Error);
    const Image after = render(scene, {32, 18}, "display");
    EXPECT_TRUE(std::ranges::equal(before.floats(), after.floats()));
}

}  // namespace
}  // namespace tyndall
