// What the technique scatter_maps makes of an interior and a light.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "physics/half_space.h"
#include "scatter_maps/scatter_block.h"

namespace tyndall::translucency {
namespace {

constexpr float kPi = std::numbers::pi_v<float>;

ScatterKey potato(float eta = 1.0f) {
    ScatterKey key;
    key.interior.sigma_s_per_m = {680, 700, 550};
    key.interior.sigma_a_per_m = {2.4f, 9.0f, 120.0f};
    key.interior.eta = eta;
    key.model = Model::photon_beams;
    key.body_radius = key.extent = 0.01f;
    return key;
}

TEST(ScatterMaps, SingleScatteringOfGroundIsChandrasekhars) {
    const ScatteringInterior interior = potato().interior;
    const glm::vec3 albedo = interior.sigma_s_per_m / (interior.sigma_s_per_m + interior.sigma_a_per_m);
    float worst = 0.0f;
    for (const float mu : {0.1f, 0.3f, 0.7f, 1.0f}) {
        const glm::vec3 exact = 0.5f * albedo * (1.0f - mu * std::log(1.0f + 1.0f / mu));
        const glm::vec3 found = single_share(interior, mu);
        for (int c = 0; c < 3; ++c) worst = std::max(worst, std::abs(found[c] / exact[c] - 1.0f));
    }
    std::printf("worst relative error of the share that scatters once: %.5f\n", double(worst));
    EXPECT_LT(worst, 2e-3f);
}

TEST(ScatterMaps, OnceAndMoreOftenIsAllThatLeaves) {
    for (const float eta : {1.0f, 1.4f}) {
        ScatterKey key = potato(eta);
        key.body_radius = 100.0f;  // ground
        const ScatterTables tables = scatter_tables(key);
        const Optics optics = optics_of(key.interior);
        const physics::HalfSpace ground(optics.albedo(), eta);
        for (int i = 1; i < ScatterBlock::kCosines; ++i) {
            const float cosine = float(i) / (ScatterBlock::kCosines - 1);
            const glm::vec3 sum =
                glm::vec3(tables.cosines[ScatterTables::multiple][size_t(i)]) + single_share(key.interior, cosine);
            for (int c = 0; c < 3; ++c) {
                EXPECT_NEAR(sum[c], ground.table()[size_t(i)][c], 3e-3f) << eta << " " << cosine;
                EXPECT_LT(sum[c], 1.0f);
            }
        }
    }
}

/// What the rings give on flat ground that faces the light, and on ground that far behind it.
glm::vec3 rings_at(const ScatterTables& tables, float behind) {
    glm::vec3 sum(0.0f);
    for (const glm::vec4& tap : tables.block.taps) {
        const float r2 = tap.x * tap.x + tap.y * tap.y + behind * behind;
        const float column =
            (tables.block.columns.x + tables.block.columns.y * std::log2(r2)) * ScatterTables::kColumns;
        const int i = std::clamp(int(column - 0.5f), 0, ScatterTables::kColumns - 2);
        sum += tap.w * glm::vec3(glm::mix(tables.kernel[0][size_t(i)], tables.kernel[0][size_t(i) + 1],
                                          column - 0.5f - float(i)));
    }
    return sum;
}

TEST(ScatterMaps, RingsGiveOutWhatHasEntered) {
    const ScatterTables tables = scatter_tables(potato());
    const glm::vec3 own(tables.cosines[ScatterTables::own].back());
    const glm::vec3 sum = own + rings_at(tables, 0.0f);
    std::printf("own %.4f %.4f %.4f, with the rings %.4f %.4f %.4f\n", double(own.x), double(own.y), double(own.z),
                double(sum.x), double(sum.y), double(sum.z));
    for (int c = 0; c < 3; ++c) {
        EXPECT_GT(sum[c], 0.93f);
        EXPECT_LT(sum[c], 1.02f);
    }
}

/// What a wall gives out on both sides of a unit that enters, as entry.frag and spread.frag do it.
glm::vec3 given_out(const ScatterTables& tables, float thickness) {
    const glm::vec3 own(tables.cosines[ScatterTables::own].back()), body(tables.block.body);
    const float at =
        (tables.block.columns.x + tables.block.columns.y * 2.0f * std::log2(thickness)) * ScatterTables::kColumns;
    const float column = std::clamp(at - 0.5f, 0.0f, float(ScatterTables::kColumns) - 1.001f);
    const auto i = size_t(column);
    const glm::vec3 scale(glm::mix(tables.kernel[1][i], tables.kernel[1][i + 1], column - float(i)));
    return own / body + scale * (rings_at(tables, 0.0f) + rings_at(tables, thickness));
}

TEST(ScatterMaps, WallsGiveOutNoMoreThanHasEntered) {
    const auto check = [](const ScatterKey& key, float thickness) {
        const glm::vec3 both = given_out(scatter_tables(key), thickness);
        std::printf("%.2f mm of a body of radius %.2f mm: %.4f %.4f %.4f of what entered\n", 1e3 * double(thickness),
                    1e3 * double(key.body_radius), double(both.x), double(both.y), double(both.z));
        for (int c = 0; c < 3; ++c) {
            EXPECT_LE(both[c], 1.0f) << thickness;
            EXPECT_GT(both[c], 0.83f) << thickness << ": what absorbs nothing goes farther than the rings reach";
        }
    };
    ScatterKey white = potato();
    white.interior.sigma_a_per_m = glm::vec3(0.0f);
    for (const ScatterKey& key : {potato(), potato(1.4f), white}) {
        for (const float thickness : {0.0001f, 0.0005f, 0.00123f, 0.002f, 0.005f, 0.00667f}) check(key, thickness);
        ScatterKey wall = key;  // all of a body
        wall.body_radius = 0.003f;
        check(wall, 0.002f);
    }
}

TEST(ScatterMaps, GreenGivesABallsLightOutOnce) {
    for (const auto falloff : {ScatterMapsFalloff::exponential, ScatterMapsFalloff::ramp}) {
        ScatterKey key = potato();
        key.settings.form = ScatterMapsForm::green;
        key.settings.falloff = falloff;
        const ScatterBlock block = scatter_tables(key).block;
        constexpr int kPlaces = 1000;
        glm::vec3 dark(0.0f);  // mean over the far half
        for (int i = 0; i < kPlaces; ++i) {
            const glm::vec3 depth = glm::vec3(block.green) * (2.0f * key.body_radius * (float(i) + 0.5f) / kPlaces);
            dark += (falloff == ScatterMapsFalloff::ramp ? glm::max(1.0f - 0.5f * depth, glm::vec3(0.0f))
                                                         : glm::exp(-depth)) /
                    float(kPlaces);
        }
        // a hemisphere is twice its disc
        const glm::vec3 sum = 1.0f - block.green.w + 2.0f * glm::vec3(block.green_amount) * (1.0f + dark);
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(sum[c], 1.0f, 2e-3f);
    }
}

}  // namespace
}  // namespace tyndall::translucency
