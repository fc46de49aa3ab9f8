// Surfaces laid out flat for diffusion in texture space.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <map>
#include <numbers>

#include "scene/primitives.h"
#include "skin_meshes.h"
#include "texture_space/atlas.h"

namespace tyndall::skin {
namespace {

double area_of(const Atlas& atlas) {
    double area = 0.0;
    for (const AtlasTexel& texel : atlas.texels) area += double(texel.area);
    return area;
}

/// The covered texel that holds a place on the map, or null.
class TexelFinder {
 public:
    explicit TexelFinder(const Atlas& atlas) {
        for (const AtlasTexel& texel : atlas.texels) at_[{texel.at.x, texel.at.y}] = &texel;
    }
    [[nodiscard]] const AtlasTexel* at(const glm::ivec2& at) const {
        const auto found = at_.find({at.x, at.y});
        return found == at_.end() ? nullptr : found->second;
    }

 private:
    std::map<std::pair<int, int>, const AtlasTexel*> at_;
};

glm::ivec2 heaviest_tap(const GutterTexel& gutter) {
    const auto heaviest = std::ranges::max_element(gutter.weights);
    return gutter.taps[size_t(heaviest - gutter.weights.begin())];
}

TEST(SkinAtlas, ASheetHasItsSizeAndItsTexelsWhereTheyBelong) {
    const Atlas atlas = make_atlas(sheet(0.2f, 0.1f, {0.1f, 0.2f}, {0.9f, 0.7f}), 100);
    ASSERT_TRUE(atlas.usable()) << atlas.problem;
    EXPECT_EQ(atlas.texels.size(), 80u * 50u);
    EXPECT_EQ(atlas.charts, 1u);
    EXPECT_NEAR(area_of(atlas), 0.02, 1e-6);
    const AtlasTexel& first = atlas.texels.front();
    EXPECT_EQ(first.at, glm::ivec2(10, 20) + kGutterTexels);
    EXPECT_NEAR(first.steps.along_u, 80 / 0.2f, 1e-2f);
    EXPECT_NEAR(first.steps.along_v, 50 / 0.1f, 1e-2f);
    EXPECT_NEAR(first.steps.lean, 0.0f, 1e-5f);
    EXPECT_NEAR(first.position.x, -0.1f + 0.5f * 0.2f / 80, 1e-6f);
    // open all around: nothing lies across its borders, and a ring pads it
    EXPECT_EQ(atlas.gutters.size(), atlas.padding);
    EXPECT_EQ(atlas.padding, 2u * (82 + 50));
}

TEST(SkinAtlas, AStretchAndALeanAreSeen) {
    const glm::mat3 shape = glm::mat3(glm::scale(glm::mat4(1.0f), {3.0f, 1.0f, 1.0f}));
    const Atlas wide = make_atlas(sheet(0.1f, 0.1f, {0, 0}, {1, 1}), 64, shape);
    EXPECT_NEAR(wide.texels.front().steps.along_u, 64 / 0.3f, 1e-2f);
    EXPECT_NEAR(area_of(wide), 0.03, 1e-6);
    // sheared by 45 degrees: across u lies v - u
    glm::mat3 shear(1.0f);
    shear[1][0] = 1.0f;  // x += y
    const Atlas sheared = make_atlas(sheet(0.1f, 0.1f, {0, 0}, {1, 1}), 64, shear);
    const TexelSteps steps = sheared.texels.front().steps;
    EXPECT_NEAR(std::abs(steps.lean), 1.0f, 1e-4f);
    EXPECT_NEAR(steps.along_v, 64 / 0.1f, 0.1f);
    EXPECT_GT(sheared.leaning, 0.99f);
    EXPECT_EQ(wide.leaning, 0.0f);
}

TEST(SkinAtlas, ASpheresSeamIsOneSurface) {
    const Mesh sphere = make_primitive(Primitive::sphere, 64);
    const Atlas atlas = make_atlas(sphere, 256);
    ASSERT_TRUE(atlas.usable()) << atlas.problem;
    const double area = area_of(atlas);
    std::printf("area of the sphere of diameter 1 by its texels: %.4f of pi\n", area / std::numbers::pi);
    EXPECT_NEAR(area / std::numbers::pi, 1.0, 5e-3);
    const TexelFinder texels(atlas);
    size_t at_seam = 0;
    float worst = 0.0f;
    for (const GutterTexel& gutter : atlas.gutters) {
        if (gutter.chart == 0) continue;
        const AtlasTexel* there = texels.at(heaviest_tap(gutter));
        ASSERT_NE(there, nullptr);
        // left of the map's first column is its last
        if (gutter.at.y < 60 + kGutterTexels || gutter.at.y > 190 + kGutterTexels) continue;
        ++at_seam;
        const float column = float(gutter.at.x) + 0.5f;
        worst = std::max(worst, std::abs(gutter.source.x - (column < 100 ? column + 256 : column - 256)));
        worst = std::max(worst, std::abs(gutter.source.y - (float(gutter.at.y) + 0.5f)));
    }
    std::printf("worst error of where the seam's other side is: %.3f texels\n", double(worst));
    EXPECT_LT(worst, 0.5f);  // at the far end; the facets there are four texels wide
    EXPECT_EQ(at_seam, 2u * 131u * kGutterTexels);
}

TEST(SkinAtlas, GuttersOfACubeShowTheFaceAround) {
    // faces with room between them, each a third of the map wide and turned its own way
    const Mesh mesh = unwrapped_cube();
    const Atlas atlas = make_atlas(mesh, 300);
    ASSERT_TRUE(atlas.usable()) << atlas.problem;
    EXPECT_EQ(atlas.charts, 6u);
    EXPECT_NEAR(area_of(atlas), 6.0, 0.01);
    const TexelFinder texels(atlas);
    std::map<uint32_t, size_t> of_chart;
    float worst = 0.0f;
    for (const GutterTexel& gutter : atlas.gutters) {
        if (gutter.chart == 0) continue;
        ++of_chart[gutter.chart];
        const AtlasTexel* there = texels.at(heaviest_tap(gutter));
        ASSERT_NE(there, nullptr);
        EXPECT_NE(there->chart, gutter.chart);
        // the way from the nearest texel of its own chart is as long on the map as around the cube's edge, to half a
        // texel's diagonal at both ends
        const AtlasTexel* own = nullptr;
        float nearest = 1e9f;
        for (int y = -12; y <= 12; ++y)
            for (int x = -12; x <= 12; ++x) {
                const AtlasTexel* texel = texels.at(gutter.at + glm::ivec2(x, y));
                const float distance = std::hypot(float(x), float(y));
                if (!texel || texel->chart != gutter.chart || distance >= nearest) continue;
                nearest = distance;
                own = texel;
            }
        if (!own) continue;
        const glm::vec3 way = glm::abs(own->position - there->position);
        const float around = way.x + way.y + way.z;  // straight across an edge: both parts add
        if (nearest < 12.0f && (gutter.at.x == own->at.x || gutter.at.y == own->at.y))
            worst = std::max(worst, std::abs(around - nearest * atlas.texel_m) / atlas.texel_m);
    }
    std::printf("worst error of a way around an edge: %.3f texels\n", double(worst));
    EXPECT_LT(worst, 1.1f);
    EXPECT_EQ(of_chart.size(), 6u);
    for (const auto& [chart, count] : of_chart) EXPECT_GE(count, 4u * kGutterTexels * 81u) << chart;
}

TEST(SkinAtlas, WhatCantBeLaidOutSaysWhy) {
    Mesh none = sheet(1, 1, {0, 0}, {1, 1});
    none.uv0.clear();
    EXPECT_NE(make_atlas(none, 64).problem.find("no UVs"), std::string::npos);

    const Atlas box = make_atlas(make_primitive(Primitive::box, 8), 64);
    std::printf("box: %s\n", box.problem.c_str());
    EXPECT_FALSE(box.usable());
    EXPECT_GT(box.overlap, 1.0f);  // six faces on one square

    const Atlas tiled = make_atlas(sheet(1, 1, {0, 0}, {3, 3}), 64);
    std::printf("tiled: %s\n", tiled.problem.c_str());
    EXPECT_FALSE(tiled.usable());
    EXPECT_TRUE(make_atlas(sheet(1, 1, {2.1f, -0.9f}, {2.9f, -0.1f}), 64).usable());

    const Atlas flat = make_atlas(sheet(1, 1, {0.5f, 0}, {0.5f, 1}), 64);
    std::printf("flat: %s\n", flat.problem.c_str());
    EXPECT_FALSE(flat.usable());

    Mesh wild = sheet(1, 1, {0, 0}, {1, 1});
    wild.uv0[0].x = std::nanf("");
    EXPECT_FALSE(make_atlas(wild, 64).usable());
    EXPECT_FALSE(make_atlas(Mesh{}, 64).usable());
}

}  // namespace
}  // namespace tyndall::skin
