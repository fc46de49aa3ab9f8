// Paint over a translucent body: how much light goes in and out.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <glm/geometric.hpp>

#include "geometry/surface_points.h"
#include "paint/paint_grid.h"
#include "scene/primitives.h"

namespace tyndall::translucency {
namespace {

constexpr float kRadius = 0.01f;  // metres

PaintedBody body_of(const glm::vec3& sigma_a) {
    return {{{680, 700, 550}, sigma_a, 1.0f}, Model::photon_beams, 2.0f * kRadius, kRadius};
}

glm::vec4 looked_up(const PaintGrid& grid, const std::vector<glm::vec4>& voxels, const glm::vec3& place) {
    const glm::vec3 at = (place - grid.box.low) / (grid.box.high - grid.box.low) * glm::vec3(grid.size);
    const glm::ivec3 v = glm::clamp(glm::ivec3(at), glm::ivec3(0), grid.size - 1);
    return voxels[(size_t(v.z) * size_t(grid.size.y) + size_t(v.y)) * size_t(grid.size.x) + size_t(v.x)];
}

/// Left half red, right half nothing.
Paint half_painted() {
    auto texture = std::make_shared<TextureAsset>();
    texture->image = Image(2, 1, 4, Image::Type::f32);
    texture->filter = TextureFilter::nearest;
    texture->image.at(0, 0, 0) = texture->image.at(0, 0, 3) = 1.0f;
    return {1.0f, glm::vec3(1.0f), {.texture = texture}};
}

TEST(PaintGrid, EvenWhitePaintKeepsAllLight) {
    const Mesh ball = make_primitive(Primitive::sphere, 64);
    for (const float cover : {0.5f, 0.9f}) {
        const PaintGrid grid = make_paint_grid(ball, {cover, glm::vec3(1.0f), {}}, body_of(glm::vec3(0.0f)), 32);
        ASSERT_FALSE(grid.empty());
        const glm::vec4 ends = looked_up(grid, grid.ends, {0.0f, 0.5f, 0.0f});
        const glm::vec4 even = looked_up(grid, grid.even, {0.0f, 0.5f, 0.0f});
        std::printf("cover %.1f: %.4f at both ends, %.4f open, %.4f leaves\n", double(cover), double(ends.x),
                    double(ends.w), double(even.x));
        EXPECT_NEAR(ends.w, 1.0f - cover, 1e-4f);
        EXPECT_NEAR(even.x, 1.0f, 0.008f) << "nothing is absorbed, but what the half-space's table rounds off";
        EXPECT_NEAR(ends.x * ends.x * ends.w, 1.0f, 0.01f) << "what is thrown back leaves elsewhere";
    }
}

TEST(PaintGrid, DarkPaintAndDarkBodiesGiveLess) {
    const Mesh ball = make_primitive(Primitive::sphere, 64);
    const auto even = [&](float colour, float absorption) {
        const PaintGrid grid = make_paint_grid(ball, {0.5f, glm::vec3(colour), {}}, body_of(glm::vec3(absorption)), 32);
        return looked_up(grid, grid.even, {0.0f, 0.5f, 0.0f}).x;
    };
    const float white = even(1.0f, 0.0f), grey = even(0.5f, 0.0f), black = even(0.0f, 0.0f), dark = even(1.0f, 100.0f);
    std::printf("white %.3f, grey %.3f, black %.3f; white over a dark body %.3f\n", double(white), double(grey),
                double(black), double(dark));
    EXPECT_LT(grey, white);
    EXPECT_LT(black, grey);
    EXPECT_NEAR(black, 0.5f, 0.01f) << "of a boundary that mirrors nothing: what meets paint is gone";
    EXPECT_LT(dark, white);
    EXPECT_GT(dark, 0.5f);
}

TEST(PaintGrid, KnowsWhereTheTextureIs) {
    const Mesh ball = make_primitive(Primitive::sphere, 64);
    const PaintGrid grid = make_paint_grid(ball, half_painted(), body_of(glm::vec3(0.0f)), 32);
    int open = 0, closed = 0;
    for (size_t i = 0; i < ball.positions.size(); ++i) {
        const float u = ball.uv0[i].x, share = looked_up(grid, grid.ends, ball.positions[i]).w;
        if (std::abs(ball.positions[i].y) > 0.4f || std::abs(std::fmod(u, 0.5f) - 0.25f) > 0.12f) continue;
        (u < 0.5f ? closed : open) += 1;
        EXPECT_NEAR(share, u < 0.5f ? 0.0f : 1.0f, 0.02f) << u;
    }
    EXPECT_GT(std::min(open, closed), 100);
    EXPECT_TRUE(make_paint_grid(Mesh{}, half_painted(), body_of(glm::vec3(0.0f)), 32).empty());
}

}  // namespace
}  // namespace tyndall::translucency
