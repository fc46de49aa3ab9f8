#include "physics/probe.h"
#include "physics_test.h"

namespace tyndall::physics {
namespace {

/// A probe of 128 x 64 pixels whose radiance is f(direction).
Sh9 probe(const std::function<float(vec3)>& f) {
    constexpr int kWidth = 128, kHeight = 64;
    std::vector<vec3> pixels(size_t(kWidth) * kHeight);
    for (int y = 0; y < kHeight; ++y) {
        for (int x = 0; x < kWidth; ++x) {
            const vec2 uv((float(x) + 0.5f) / kWidth, (float(y) + 0.5f) / kHeight);
            pixels[size_t(y) * kWidth + size_t(x)] = vec3(f(equirect_to_direction(uv)));
        }
    }
    return project_equirect(pixels, kWidth, kHeight);
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
