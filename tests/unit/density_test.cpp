// Density fields: values against closed forms, and bounds that nothing inside their box exceeds.

#include <gtest/gtest.h>

#include <glm/ext/matrix_transform.hpp>
#include <random>

#include "physics/physics.h"
#include "scene/density.h"

namespace tyndall {
namespace {

class Random {
 public:
    explicit Random(unsigned seed) : engine_(seed) {}
    float between(float low, float high) { return low + (high - low) * float(engine_() >> 8) * 0x1p-24f; }
    glm::vec3 inside(const Bounds& box) {
        const float x = between(box.low.x, box.high.x), y = between(box.low.y, box.high.y);
        return {x, y, between(box.low.z, box.high.z)};
    }

 private:
    std::mt19937 engine_;
};

const Bounds kUnitBox{glm::vec3(-0.5f), glm::vec3(0.5f)};

glm::mat4 placement() {
    const glm::mat4 turned = glm::rotate(glm::translate(glm::mat4(1.0f), {3, 20, -7}), 0.7f, {0.3f, 1.0f, 0.5f});
    return glm::scale(turned, {4, 6, 3});
}

DensityField grid_field(glm::ivec3 size, float scale) {
    auto asset = std::make_shared<VolumeAsset>();
    Random random(3);
    asset->volume.size = size;
    for (int i = 0; i < size.x * size.y * size.z; ++i)
        asset->volume.values.push_back(std::max(0.0f, random.between(-1.0f, 1.0f)));
    GridDensity grid{asset, glm::mat4(1.0f), scale};
    grid.to_volume = glm::translate(glm::mat4(1.0f), glm::vec3(0.5f));
    return grid;
}

DensityField blob_field() {
    BlobDensity density;
    Random random(4);
    for (int i = 0; i < 30; ++i)
        density.blobs.push_back({random.inside(kUnitBox), random.between(0.02f, 0.2f), random.between(-0.2f, 1.0f)});
    return density;
}

/// 1e5 points in 2000 boxes of all sizes; the share of boxes whose bound is within `tight` of a value that was seen.
double check_bounds(const DensityEvaluator& density, float tight) {
    Random random(11);
    int near = 0;
    for (int i = 0; i < 2000; ++i) {
        Bounds box;
        const glm::vec3 middle = random.inside({glm::vec3(-0.7f), glm::vec3(0.7f)});
        const float half = std::exp(random.between(-6.0f, -0.5f));
        box.add(middle - half);
        box.add(middle + half * glm::vec3(1.0f, 0.5f, 2.0f));
        const float bound = density.upper_bound(box);
        float greatest = 0.0f;
        for (int k = 0; k < 50; ++k) {
            const float value = density.at(random.inside(box));
            EXPECT_GE(value, 0.0f);
            EXPECT_LE(value, bound) << i;
            greatest = std::max(greatest, value);
        }
        near += bound <= greatest * (1.0f + tight) + 1e-3f;
    }
    return near / 2000.0;
}

TEST(Density, ConstantIsOneEverywhere) {
    const DensityEvaluator density(ConstantDensity{}, placement(), 3.0);
    EXPECT_TRUE(density.constant());
    EXPECT_EQ(density.at({9, 9, 9}), 1.0f);
    EXPECT_EQ(density.upper_bound(kUnitBox), 1.0f);
}

TEST(Density, HeightFallsWithTheHeightInTheWorld) {
    const DensityEvaluator density(HeightDensity{18.0f, 2.5f}, placement(), 0.0);
    EXPECT_FALSE(density.constant());
    Random random(1);
    for (int i = 0; i < 1000; ++i) {
        const glm::vec3 p = random.inside(kUnitBox);
        const glm::dvec4 world = glm::dmat4(placement()) * glm::dvec4(p, 1.0);
        EXPECT_NEAR(density.at(p) / std::exp(-(world.y - 18.0) / 2.5), 1.0, 1e-6);
    }
    EXPECT_GT(check_bounds(density, 0.5f), 0.6);
    const DensityEvaluator far_below(HeightDensity{1e9f, 0.001f}, placement(), 0.0);
    EXPECT_TRUE(std::isfinite(far_below.at(glm::vec3(0.0f))));
}

TEST(Density, BlobsAddUp) {
    const BlobDensity blobs{{{{0.1f, 0.2f, 0.3f}, 0.15f, 2.0f}, {{-0.3f, 0.0f, 0.0f}, 0.05f, 1.0f}}};
    const DensityEvaluator density(blobs, placement(), 0.0);
    EXPECT_FLOAT_EQ(density.at({0.1f, 0.2f, 0.3f}), 2.0f);
    EXPECT_NEAR(density.at({0.1f, 0.2f, 0.45f}), 2.0f * std::exp(-0.5f), 1e-6f);
    EXPECT_NEAR(density.at({-0.3f, 0.1f, 0.0f}),
                std::exp(-2.0f) + 2.0f * std::exp(-0.5f * (0.16f + 0.01f + 0.09f) / 0.0225f), 1e-6f);
    EXPECT_EQ(density.at({5, 5, 5}), 0.0f);
    EXPECT_NEAR(density.upper_bound({{0.1f, 0.2f, 0.45f}, {0.2f, 0.3f, 0.6f}}), 2.0f * std::exp(-0.5f), 1e-4f);
}

TEST(Density, BlobBoundsHoldAndAreTight) {
    EXPECT_GT(check_bounds(DensityEvaluator(blob_field(), placement(), 0.0), 0.3f), 0.4);
}

TEST(Density, NoiseIsThatOfPhysicsAndMovesWithTheWind) {
    NoiseDensity noise;
    noise.feature_m = 2.0f;
    noise.wind_m_s = {1.0f, 0.5f, 0.0f};
    const DensityEvaluator start(noise, placement(), 0.0), later(noise, placement(), 8.0);
    Random random(2);
    for (int i = 0; i < 200; ++i) {
        const glm::vec3 p = random.inside(kUnitBox);
        const glm::vec3 world(placement() * glm::vec4(p, 1.0f));
        EXPECT_NEAR(start.at(p), physics::noise_density(world / 2.0f, 4, 0.5f), 3e-4f);
        EXPECT_NEAR(later.at(p), physics::noise_density((world - glm::vec3(8, 4, 0)) / 2.0f, 4, 0.5f), 3e-4f);
    }
    EXPECT_GT(check_bounds(start, 0.3f), 0.3);
}

TEST(Density, GridIsTrilinearBetweenCentresAndEmptyOutside) {
    const DensityField field = grid_field({4, 5, 6}, 2.0f);
    const Volume& volume = std::get<GridDensity>(field).volume->volume;
    const DensityEvaluator density(field, placement(), 0.0);
    const auto local = [&](glm::vec3 voxel) { return (voxel + 0.5f) / glm::vec3(volume.size) - 0.5f; };
    EXPECT_NEAR(density.at(local({2, 3, 4})), 2.0f * volume.at(2, 3, 4), 1e-5f);
    EXPECT_NEAR(density.at(local({2.25f, 3, 4})), 2.0f * glm::mix(volume.at(2, 3, 4), volume.at(3, 3, 4), 0.25f),
                1e-5f);
    EXPECT_NEAR(density.at(local({2, 3.5f, 4.5f})),
                0.5f * (volume.at(2, 3, 4) + volume.at(2, 4, 4) + volume.at(2, 3, 5) + volume.at(2, 4, 5)), 1e-5f);
    EXPECT_NEAR(density.at(local({-0.4f, 0, 0})), 2.0f * volume.at(0, 0, 0), 1e-5f) << "the rim keeps its value";
    EXPECT_EQ(density.at({0.51f, 0, 0}), 0.0f);
    EXPECT_EQ(density.upper_bound({{0.6f, -0.5f, -0.5f}, {0.9f, 0.5f, 0.5f}}), 0.0f);
}

TEST(Density, GridBoundsHoldAndAreTight) {
    const DensityEvaluator small(grid_field({7, 5, 3}, 1.5f), placement(), 0.0);
    EXPECT_GT(check_bounds(small, 0.8f), 0.5);
    const DensityField field = grid_field({65, 34, 50}, 1.0f);
    check_bounds(DensityEvaluator(field, placement(), 0.0), 0.0f);
    const Volume& volume = std::get<GridDensity>(field).volume->volume;
    const float greatest = *std::max_element(volume.values.begin(), volume.values.end());
    EXPECT_NEAR(DensityEvaluator(field, placement(), 0.0).upper_bound(kUnitBox), greatest, 1e-4f);
}

TEST(Density, AGridFarFromTheOriginKeepsItsBounds) {
    DensityField field = grid_field({64, 64, 64}, 1.0f);
    auto& grid = std::get<GridDensity>(field);
    grid.to_volume = glm::translate(glm::mat4(1.0f), {-999.5f, 0.5f, 0.5f});
    const DensityEvaluator density(field, placement(), 0.0);
    Random random(5);
    for (int i = 0; i < 2000; ++i) {
        const glm::vec3 low = random.inside(kUnitBox) + glm::vec3(1000, 0, 0);
        const Bounds box{low, low + 0.004f};
        const float bound = density.upper_bound(box);
        for (int k = 0; k < 20; ++k) EXPECT_LE(density.at(random.inside(box)), bound);
    }
}

TEST(Density, PuffsAndSwirlsStayBelowTheirBounds) {
    NoiseDensity noise;
    noise.feature_m = 2.0f;
    noise.kind = NoiseKind::worley;
    EXPECT_GT(check_bounds(DensityEvaluator(noise, placement(), 0.0), 0.3f), 0.3);
    noise.swirl = 1.0f;
    noise.churn_per_s = 0.5f;
    const DensityEvaluator swirled(noise, placement(), 2.0);
    check_bounds(swirled, 0.3f);
    noise.swirl = 0.0f;
    EXPECT_NE(swirled.at({0.1f, 0.2f, 0.3f}), DensityEvaluator(noise, placement(), 2.0).at({0.1f, 0.2f, 0.3f}));
}

TEST(Density, GradientsAreRampsInTheBox) {
    const DensityEvaluator linear(GradientDensity{.start = 2.0f, .end = 0.5f}, placement(), 0.0);
    EXPECT_FLOAT_EQ(linear.at({0.3f, -0.5f, 0.1f}), 2.0f);
    EXPECT_FLOAT_EQ(linear.at({0.3f, 0.0f, 0.1f}), 1.25f);
    EXPECT_FLOAT_EQ(linear.at({0.3f, 0.9f, 0.1f}), 0.5f);
    EXPECT_GT(check_bounds(linear, 0.3f), 0.9);
    const GradientDensity ball{.radial = true, .from = {0.1f, 0.0f, 0.0f}, .inner = 0.1f, .outer = 0.4f};
    const DensityEvaluator radial(ball, placement(), 0.0);
    EXPECT_FLOAT_EQ(radial.at({0.1f, 0.0f, 0.05f}), 1.0f);
    EXPECT_FLOAT_EQ(radial.at({0.1f, 0.25f, 0.0f}), 0.5f);
    EXPECT_EQ(radial.at({-0.4f, 0.3f, 0.0f}), 0.0f);
    EXPECT_GT(check_bounds(radial, 0.3f), 0.5);
    GradientDensity hollow = ball;
    std::swap(hollow.start, hollow.end);
    check_bounds(DensityEvaluator(hollow, placement(), 0.0), 0.3f);
}

TEST(Density, AProductIsItsFactorsAndBoundedByThem) {
    NoiseDensity noise;
    noise.feature_m = 1.5f;
    const DensityField mask = grid_field({9, 8, 7}, 1.0f);
    const ProductDensity product{std::make_shared<const DensityField>(noise), std::get<GridDensity>(mask),
                                 HeightDensity{18.0f, 2.5f}};
    const DensityEvaluator density(product, placement(), 1.0);
    const DensityEvaluator factors[] = {
        {noise, placement(), 1.0}, {mask, placement(), 1.0}, {HeightDensity{18.0f, 2.5f}, placement(), 1.0}};
    Random random(12);
    for (int i = 0; i < 500; ++i) {
        const glm::vec3 p = random.inside(kUnitBox);
        EXPECT_FLOAT_EQ(density.at(p), factors[0].at(p) * factors[1].at(p) * factors[2].at(p));
    }
    check_bounds(density, 0.5f);
    EXPECT_FALSE(density.constant());
}

TEST(Density, WithoutAVolumeThereIsNothing) {
    const DensityEvaluator density(GridDensity{}, placement(), 0.0);
    EXPECT_EQ(density.at(glm::vec3(0.0f)), 0.0f);
    EXPECT_EQ(density.upper_bound(kUnitBox), 0.0f);
    auto asset = std::make_shared<VolumeAsset>();
    asset->volume.size = {1, 1, 1};
    asset->volume.values = {1.0f};
    GridDensity endless{asset, glm::mat4(std::numeric_limits<float>::infinity()), 1.0f};
    EXPECT_EQ(DensityEvaluator(endless, placement(), 0.0).at(glm::vec3(0.0f)), 0.0f);
}

}  // namespace
}  // namespace tyndall
