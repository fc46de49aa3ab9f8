// Profiles of skin as scenes choose them: every kind, what is refused, what the program prints.

#include <gtest/gtest.h>

#include <cmath>

#include "core/error.h"
#include "physics/radial_profile.h"
#include "profile_choice.h"

namespace tyndall::skin {
namespace {

LayersProfile one_layer(float thickness_mm) {
    LayersProfile profile;
    profile.layers.resize(1);
    profile.layers[0].thickness_mm = thickness_mm;
    return profile;
}

std::string refusal(const ProfileChoice& choice) {
    try {
        (void)make_profile(choice);
    } catch (const Error& error) {
        return error.what();
    }
    return {};
}

float edge_mm(const MadeProfile& made, int channel) {
    return 1e3f * float(physics::edge_width([&](double x) { return double(made.profile.edge(float(x))[channel]); }));
}

TEST(SkinProfiles, EachKindSpreadsRedFarthest) {
    GaussiansProfile two;
    two.lobes = {{0.01f, {0.2f, 0.5f, 1.0f}}, {1.0f, {0.8f, 0.5f, 0.1f}}};
    for (const ProfileChoice& choice :
         {ProfileChoice{SixGaussiansProfile{}}, ProfileChoice{Skin1Profile{}}, ProfileChoice{Skin2Profile{}},
          ProfileChoice{ThreeLayersProfile{}}, ProfileChoice{BurleyProfile{}}, ProfileChoice{one_layer(0.0f)},
          ProfileChoice{one_layer(2.0f)}, ProfileChoice{two}}) {
        const auto made = made_profile(choice);
        const std::string name = profile_names()[choice.index()];
        std::printf("%-14s edge 10-90 %% %.3f %.3f %.3f mm, albedo %.3f %.3f %.3f, edge error %.4f %.4f %.4f\n",
                    name.c_str(), edge_mm(*made, 0), edge_mm(*made, 1), edge_mm(*made, 2), made->albedo.x,
                    made->albedo.y, made->albedo.z, made->edge_error.x, made->edge_error.y, made->edge_error.z);
        glm::vec3 sum(0.0f);
        for (const physics::DiffusionLobe& lobe : made->profile.lobes) sum += lobe.weight;
        for (int c = 0; c < 3; ++c) {
            EXPECT_NEAR(sum[c], 1.0f, 1e-5f) << name;
            EXPECT_LT(made->edge_error[c], 0.005f) << name;
        }
        EXPECT_GT(edge_mm(*made, 0), edge_mm(*made, 2)) << name;
    }
}

TEST(SkinProfiles, TheSameChoiceIsMadeOnce) {
    const auto first = made_profile(ThreeLayersProfile{});
    EXPECT_EQ(made_profile(ThreeLayersProfile{}), first);
    BurleyProfile other;
    other.albedo.x = 0.5f;
    EXPECT_NE(made_profile(other), made_profile(BurleyProfile{}));
}

TEST(SkinProfiles, RefuseWhatIsNone) {
    EXPECT_NE(refusal(GaussiansProfile{}).find("no lobe"), std::string::npos);
    GaussiansProfile gaussians;
    gaussians.lobes = {{1.0f, {1.0f, 0.0f, 1.0f}}};
    EXPECT_NE(refusal(gaussians).find("sum to 0"), std::string::npos);
    gaussians.lobes = {{1.0f, glm::vec3(1.0f)}, {-2.0f, glm::vec3(1.0f)}};
    EXPECT_NE(refusal(gaussians).find("lobe 1: a variance_mm2 of -2"), std::string::npos) << refusal(gaussians);
    gaussians.lobes = {{1.0f, {1.0f, -0.1f, 1.0f}}};
    EXPECT_NE(refusal(gaussians).find("negative"), std::string::npos);
    gaussians.lobes = {{std::nanf(""), glm::vec3(1.0f)}};
    EXPECT_NE(refusal(gaussians), "");
    EXPECT_NE(refusal(LayersProfile{}).find("no layer"), std::string::npos);
    LayersProfile layers = one_layer(0.0f);
    layers.layers.push_back(layers.layers[0]);
    EXPECT_NE(refusal(layers).find("layer 0: thickness_mm is 0"), std::string::npos) << refusal(layers);
    layers.layers[0].thickness_mm = 1.0f;
    EXPECT_EQ(refusal(layers), "");
    layers.layers[1].scattering_per_mm.y = 0.0f;
    EXPECT_NE(refusal(layers).find("layer 1: each channel's scattering_per_mm"), std::string::npos);
    layers.layers[1] = {0.0f, glm::vec3(-1.0f)};
    EXPECT_NE(refusal(layers), "");
    layers.layers[1] = {0.0f, glm::vec3(1.0f), glm::vec3(1.0f), 0.5f};
    EXPECT_NE(refusal(layers).find("ior of 0.5"), std::string::npos);
    EXPECT_NE(refusal(BurleyProfile{glm::vec3(0.0f)}), "");
    EXPECT_NE(refusal(BurleyProfile{glm::vec3(0.5f), glm::vec3(0.0f)}), "");
}

TEST(SkinProfiles, StayFiniteAtTheEndsOfTheRanges) {
    const glm::vec3 one(1.0f);
    for (const float thickness : {0.0f, 1e-3f, 1e4f})
        for (const ProfileLayer& layer : {ProfileLayer{thickness, 0.0f * one, 1e4f * one, 2.0f},
                                          ProfileLayer{thickness, 1e4f * one, 1e4f * one, 1.0f},
                                          ProfileLayer{thickness, 1e4f * one, 1e-4f * one, 1.0f},
                                          ProfileLayer{thickness, 0.0f * one, 1e-4f * one, 2.0f}}) {
            SCOPED_TRACE(layer.thickness_mm);
            SCOPED_TRACE(layer.scattering_per_mm.x);
            SCOPED_TRACE(layer.absorption_per_mm.x);
            const auto made = made_profile(LayersProfile{{layer}});
            ASSERT_FALSE(made->profile.lobes.empty());
            for (const auto& [variance, weight] : made->profile.lobes)
                ASSERT_TRUE(std::isfinite(variance) && variance > 0.0f && weight.x >= 0.0f && weight.x <= 1.001f);
            ASSERT_TRUE(made->albedo.x >= 0.0f && made->albedo.x < 1.001f) << made->albedo.x;
            ASSERT_TRUE(std::isfinite(made->transmittance->at(1e-3f).x));
        }
}

}  // namespace
}  // namespace tyndall::skin
