#include <gmock/gmock.h>

#include "light_fixture.h"

namespace tyndall {
namespace {

/// Lights and gobos without shadows.
class LightingTest : public LightTest {
 protected:
    /// Red top left, green top right, blue bottom left, white bottom right.
    static std::shared_ptr<const TextureAsset> quarters(int size = 64) {
        static uint64_t ids = 2'000'000;
        auto asset = std::make_shared<TextureAsset>();
        asset->id = ++ids;
        asset->image = Image(size, size, 3, Image::Type::f32);
        for (int y = 0; y < size; ++y)
            for (int x = 0; x < size; ++x) {
                const bool right = x >= size / 2, bottom = y >= size / 2;
                const glm::vec3 colour = bottom ? (right ? glm::vec3(1, 1, 1) : glm::vec3(0, 0, 1))
                                                : (right ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0));
                for (int c = 0; c < 3; ++c) asset->image.at(x, y, c) = colour[c];
            }
        return asset;
    }
    Light& add_plain(LightKind kind, glm::vec3 from, glm::vec3 at) {
        Light& light = add_light(kind, from, at);
        light.shadow.enabled = false;
        return light;
    }
    static void expect_near(const glm::vec3& a, const glm::vec3& b) {
        for (int i = 0; i < 3; ++i) EXPECT_NEAR(a[i], b[i], 1e-3f * (1.0f + std::abs(b[i]))) << "channel " << i;
    }
};

TEST_F(LightingTest, PointFollowsTheInverseSquareAndItsWindow) {
    add_plain(LightKind::point, {0, 2, 0}, {0, 0, 0});
    render();
    expect_near(irradiance({0, 0, 0}), glm::vec3(25.0f));
    expect_near(irradiance({0, -8, 0}), glm::vec3(1.0f));
    scene_.lights[0].range_m = 5.0f;
    render();
    expect_near(irradiance({0, -3, 0}), glm::vec3(0.0f));
    const float window = 1.0f - std::pow(2.0f / 5.0f, 4.0f);
    expect_near(irradiance({0, 0, 0}), glm::vec3(25.0f * window * window));
}

TEST_F(LightingTest, SpotEndsAtItsCone) {
    Light& light = add_plain(LightKind::spot, {0, 0, 0}, {0, 0, -1});
    light.inner_angle = 0.2f;
    light.outer_angle = 0.5f;
    render();
    const auto at = [&](float angle) {
        return irradiance(10.0f * glm::vec3(std::sin(angle), 0.0f, -std::cos(angle))).x;
    };
    EXPECT_NEAR(at(0.0f), 1.0f, 1e-3f);
    EXPECT_NEAR(at(0.19f), 1.0f, 1e-3f);
    EXPECT_GT(at(0.35f), 0.1f);
    EXPECT_LT(at(0.35f), 0.9f);
    EXPECT_EQ(at(0.51f), 0.0f);
    EXPECT_EQ(at(3.0f), 0.0f);
}

TEST_F(LightingTest, DirectionalIsTheSameEverywhere) {
    add_plain(LightKind::directional, {3, 4, 0}, {0, 0, 0});
    render();
    expect_near(irradiance({0, 0, 0}), glm::vec3(100.0f));
    expect_near(irradiance({50, -100, 7}), glm::vec3(100.0f));
}

TEST_F(LightingTest, SpotGoboStandsUprightSeenFromTheLight) {
    Light& light = add_plain(LightKind::spot, {0, 0, 0}, {0, 0, -1});  // right +X, up +Y
    light.outer_angle = light.inner_angle = 0.6f;
    light.gobo = quarters();
    render();
    const float at = 10.0f * std::tan(0.6f) * 0.5f;
    const auto colour = [&](float x, float y) { return glm::sign(irradiance({x, y, -10.0f})); };
    expect_near(colour(-at, at), {1, 0, 0});
    expect_near(colour(at, at), {0, 1, 0});
    expect_near(colour(-at, -at), {0, 0, 1});
    expect_near(colour(at, -at), {1, 1, 1});
}

TEST_F(LightingTest, DirectionalGoboSpansItsRectangleAndGoesOnAtTheEdge) {
    Light& light = add_plain(LightKind::directional, {1, 2, 0}, {1, 2, -1});
    light.gobo = quarters();
    light.gobo_size_m = {4.0f, 2.0f};
    render();
    const auto colour = [&](float x, float y) { return irradiance({1.0f + x, 2.0f + y, -30.0f}) / 100.0f; };
    expect_near(colour(-1.9f, 0.9f), {1, 0, 0});
    expect_near(colour(0.2f, 0.2f), {0, 1, 0});
    expect_near(colour(-0.2f, -0.2f), {0, 0, 1});
    expect_near(colour(1.9f, -0.9f), {1, 1, 1});
    expect_near(colour(-9.0f, 9.0f), {1, 0, 0});
}

TEST_F(LightingTest, GobosOfDifferentSizesShareOneTexture) {
    Light& first = add_plain(LightKind::directional, {0, 0, 0}, {0, 0, -1});
    first.gobo = quarters(16);
    first.gobo_size_m = {2, 2};
    Light& second = add_plain(LightKind::directional, {0, 0, 0}, {0, 0, -1});
    second.gobo = quarters(128);
    second.gobo_size_m = {2, 2};
    render();
    expect_near(irradiance({-0.5f, 0.5f, 0}, 0), {100, 0, 0});
    expect_near(irradiance({0.5f, 0.5f, 0}, 1), {0, 100, 0});
}

TEST_F(LightingTest, FarAwayGobosAreAveraged) {
    Light& light = add_plain(LightKind::directional, {0, 0, 0}, {0, 0, -1});
    light.gobo = quarters(256);
    light.gobo_size_m = {1, 1};
    look_from({0, 0, 5000}, {0, 0, 0});
    render();
    expect_near(irradiance({0.3f, 0.3f, 0}), glm::vec3(50, 50, 50));
}

}  // namespace
}  // namespace tyndall
