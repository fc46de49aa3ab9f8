#include <algorithm>

#include "physics/probe.h"
#include "physics_test.h"

namespace tyndall::physics {
namespace {

constexpr int kWidth = 128, kHeight = 64;

/// An image of a probe whose radiance is f(direction).
std::vector<vec3> image_of(const std::function<vec3(vec3)>& f) {
    std::vector<vec3> pixels(size_t(kWidth) * kHeight);
    for (int y = 0; y < kHeight; ++y) {
        for (int x = 0; x < kWidth; ++x) {
            const vec2 uv((float(x) + 0.5f) / kWidth, (float(y) + 0.5f) / kHeight);
            pixels[size_t(y) * kWidth + size_t(x)] = f(equirect_to_direction(uv));
        }
    }
    return pixels;
}

Sh9 probe(const std::function<float(vec3)>& f) {
    return project_equirect(image_of([&](vec3 d) { return vec3(f(d)); }), kWidth, kHeight);
}

std::vector<DistantLight> lights_of(const std::function<vec3(vec3)>& f, int count) {
    return lights_of_equirect(image_of(f), kWidth, kHeight, count);
}

/// Of a plane by lights.
vec3 irradiance(const std::vector<DistantLight>& lights, vec3 normal) {
    vec3 sum(0.0f);
    for (const DistantLight& light : lights) sum += light.illuminance * max(dot(light.direction, normal), 0.0f);
    return sum;
}

TEST(Sh, ConstantLightGivesPi) {
    const Sh9 sh = probe([](vec3) { return 1.0f; });
    double worst = 0;
    Random random(4);
    for (int i = 0; i < 100; ++i)
        worst = std::max(worst, std::abs(double(sh9_irradiance(sh, random.direction()).y) - 3.14159265));
    EXPECT_LT(worst, 2e-3);
    measured("SH irradiance of constant light, worst error (exact: pi)", worst);
}

TEST(Sh, LinearLightIsExact) {
    // radiance 1 + 0.8 d.a gives irradiance pi + (2 pi / 3) 0.8 n.a, which three bands hold exactly
    const vec3 a = normalize(vec3(0.3f, 0.8f, -0.5f));
    const Sh9 sh = probe([&](vec3 d) { return 1 + 0.8f * dot(d, a); });
    Random random(4);
    for (int i = 0; i < 100; ++i) {
        const vec3 n = random.direction();
        EXPECT_NEAR(sh9_irradiance(sh, n).x, kPi + kTwoPi / 3 * 0.8f * dot(n, a), 4e-3f);
        EXPECT_NEAR(sh9_evaluate(sh, n).x, 1 + 0.8f * dot(n, a), 4e-3f);
    }
}

TEST(Sh, ClampedCosineLight) {
    // radiance max(d.a, 0): irradiance toward a is the integral of cos^2 over the hemisphere, 2 pi / 3
    const vec3 a(0, 1, 0);
    const Sh9 sh = probe([&](vec3 d) { return max(dot(d, a), 0.0f); });
    EXPECT_NEAR(sh9_irradiance(sh, a).x / (kTwoPi / 3), 1.0f, 0.02f);
    EXPECT_NEAR(sh9_irradiance(sh, -a).x, 0.0f, 0.05f);
    measured("SH irradiance of a cosine lobe, relative error at its axis",
             std::abs(double(sh9_irradiance(sh, a).x / (kTwoPi / 3) - 1)));
}

TEST(Sh, EquirectGoesThereAndBack) {
    Random random(8);
    for (int i = 0; i < 100; ++i) {
        const vec3 d = random.direction();
        EXPECT_LT(length(equirect_to_direction(direction_to_equirect(d)) - d), 2e-4f);
    }
    EXPECT_LT(length(equirect_to_direction(vec2(0.5f)) - vec3(0, 0, -1)), 1e-6f);
    EXPECT_NEAR(direction_to_equirect(vec3(1, 0, 0)).x, 0.75f, 1e-6f);
    EXPECT_NEAR(direction_to_equirect(vec3(0, 1, 0)).y, 0.0f, 1e-6f);
}

TEST(DistantLights, AreOfEqualLuminanceAndAddUpToTheImage) {
    const std::vector<DistantLight> lights = lights_of([](vec3 d) { return vec3(2 + d.x + d.y); }, 50);
    ASSERT_EQ(lights.size(), 50u);
    float sum = 0;
    for (const DistantLight& light : lights) {
        EXPECT_NEAR(light.illuminance.x, 2 * 4 * kPi / 50, 1e-3f);
        EXPECT_NEAR(length(light.direction), 1, 1e-5f);
        sum += light.illuminance.x;
    }
    EXPECT_NEAR(sum / (2 * 4 * kPi), 1, 1e-4f);
}

TEST(DistantLights, ConstantLightGivesPi) {
    Random random(4);
    for (const auto& [count, bound] : {std::pair(16, 0.09), std::pair(64, 0.02), std::pair(256, 0.004)}) {
        const std::vector<DistantLight> lights = lights_of([](vec3) { return vec3(1); }, count);
        double worst = 0;
        for (int i = 0; i < 500; ++i)
            worst = std::max(worst, std::abs(double(irradiance(lights, random.direction()).y) / double(kPi) - 1));
        EXPECT_LT(worst, bound) << count;
        measured("irradiance of constant light by distant lights, worst error of any plane (exact: pi)", worst);
    }
}

TEST(DistantLights, ACapGivesItsIlluminanceFromWithin) {
    const vec3 axis = normalize(vec3(0.4f, 0.5f, -0.7f));
    const float cosine = std::cos(radians(30.0f));
    const std::vector<DistantLight> lights = lights_of([&](vec3 d) { return vec3(dot(d, axis) > cosine ? 5 : 0); }, 64);
    for (const DistantLight& light : lights) EXPECT_GT(dot(light.direction, axis), cosine - 0.04f);  // a pixel
    EXPECT_NEAR(irradiance(lights, axis).x / (5 * kPi * (1 - cosine * cosine)), 1, 0.01f);
    EXPECT_NEAR(irradiance(lights, -axis).x, 0, 1e-6f);
}

TEST(DistantLights, KeepColour) {
    // red from one side, as luminous blue from the other: equally many lights of each
    const vec3 red(1 / 0.2126f, 0, 0), blue(0, 0, 1 / 0.0722f);
    const std::vector<DistantLight> lights = lights_of([&](vec3 d) { return d.x > 0 ? red : blue; }, 100);
    vec3 sum(0);
    for (const DistantLight& light : lights) {
        EXPECT_EQ(light.illuminance.x > 0, light.direction.x > 0);
        sum += light.illuminance;
    }
    EXPECT_NEAR(sum.x / (kTwoPi * red.x), 1, 0.03f);
    EXPECT_NEAR(sum.z / (kTwoPi * blue.z), 1, 0.03f);
}

TEST(DistantLights, FollowSolidAngleNotPixels) {
    // rows are equally bright, and those at the poles are short: 1/8 of the rows is 3.8 % of the sphere
    const std::vector<DistantLight> lights = lights_of([](vec3) { return vec3(1); }, 1000);
    const float cosine = std::cos(kPi / 8);
    const auto within = [&](const DistantLight& light) { return light.direction.y > cosine; };
    EXPECT_NEAR(double(std::ranges::count_if(lights, within)), 1000 * 0.5 * (1 - double(cosine)), 2);
}

TEST(DistantLights, OfOnePixelAreOneLight) {
    std::vector<vec3> pixels(size_t(kWidth) * kHeight, vec3(0));
    pixels[size_t(20) * kWidth + 90] = vec3(3000, 2000, 1000);
    const std::vector<DistantLight> lights = lights_of_equirect(pixels, kWidth, kHeight, 16);
    ASSERT_EQ(lights.size(), 1u);
    EXPECT_GT(dot(lights[0].direction, equirect_to_direction(vec2(90.5f / kWidth, 20.5f / kHeight))), 0.9997f);
    const float solid_angle = (std::cos(kPi * 20 / kHeight) - std::cos(kPi * 21 / kHeight)) * kTwoPi / kWidth;
    for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(lights[0].illuminance[c] / (pixels[20 * kWidth + 90][c] * solid_angle), 1, 1e-4f);
}

TEST(DistantLights, BlackImagesGiveNoneAndBlackPlacesNoLight) {
    EXPECT_TRUE(lights_of([](vec3) { return vec3(0); }, 16).empty());
    EXPECT_TRUE(lights_of([](vec3) { return vec3(1); }, 0).empty());
    const std::vector<DistantLight> lights = lights_of([](vec3 d) { return vec3(d.y > 0 ? 1 : 0, 0, 0); }, 333);
    for (const DistantLight& light : lights) {
        EXPECT_GT(light.direction.y, 0);
        EXPECT_GT(light.illuminance.x, 0);
    }
}

TEST(Spot, ProfilesAreAsDocumented) {
    const float outer = std::cos(radians(35.0f)), inner = spot_cos_inner_from_blend(outer, 0.2f);
    for (float degrees = 0; degrees <= 40; degrees += 0.5f) {
        const float c = std::cos(radians(degrees));
        const float x = clamp((c - outer) / ((1 - outer) * 0.2f), 0.0f, 1.0f);
        EXPECT_NEAR(spot_falloff(SPOT_SMOOTHSTEP, c, inner, outer), smoothstep(0.0f, 1.0f, x), 1e-5f) << degrees;
        // the formula of KHR_lights_punctual
        const float scale = 1 / max(0.001f, inner - outer), offset = -outer * scale;
        const float gltf = square(clamp(c * scale + offset, 0.0f, 1.0f));
        EXPECT_NEAR(spot_falloff(SPOT_SQUARED_LINEAR, c, inner, outer), gltf, 1e-5f) << degrees;
    }
    EXPECT_EQ(spot_falloff(SPOT_SMOOTHSTEP, 0.9f, 0.5f, 0.5f), 1.0f);  // no ramp at all
    EXPECT_EQ(spot_falloff(SPOT_SMOOTHSTEP, 0.4f, 0.5f, 0.5f), 0.0f);
}

TEST(Units, ExposureAndDistance) {
    EXPECT_NEAR(exposure_from_ev100(0), 1 / 1.2f, 1e-6f);
    EXPECT_NEAR(exposure_from_ev100(15) * 1.2f * 32768, 1, 1e-5f);
    EXPECT_NEAR(ev100_from_camera(16, 1 / 125.0f, 100), 14.966f, 1e-3f);
    EXPECT_FLOAT_EQ(point_irradiance(100, 2), 25);
    EXPECT_TRUE(std::isfinite(point_irradiance(100, 0)));
    EXPECT_EQ(range_window(50, 0), 1.0f);
    EXPECT_EQ(range_window(10, 10), 0.0f);
    EXPECT_GT(range_window(1, 10), 0.999f);
    EXPECT_FLOAT_EQ(luminance_rec709(vec3(1)), 1);
}

}  // namespace
}  // namespace tyndall::physics
