// Diffusion in texture space against what the profile says.

#include <fmt/format.h>

#include <cmath>
#include <functional>
#include <map>

#include "core/paths.h"
#include "gpu_fixture.h"
#include "scene/primitives.h"
#include "skin_meshes.h"
#include "texture_space/hable_taps.h"
#include "texture_space/surface_maps.h"

namespace tyndall::skin {
namespace {

const physics::DiffusionProfile kSkin = physics::six_gaussian_skin();

std::array<Atlas, LobeBlurs::kLevels> atlases_of(const Mesh& mesh, int size) {
    std::array<Atlas, LobeBlurs::kLevels> atlases;
    for (int level = 0; level < LobeBlurs::kLevels; ++level) atlases[size_t(level)] = make_atlas(mesh, size >> level);
    return atlases;
}

/// A light map, spread.
struct Spread {
    std::array<Atlas, LobeBlurs::kLevels> atlases;
    std::vector<glm::vec4> before, after;  ///< all texels of the map
    LobePlan plan;

    /// As a bilinear lookup finds it; texels from the map's corner.
    [[nodiscard]] glm::vec3 at(const glm::vec2& place) const {
        const glm::vec2 low = glm::floor(place - 0.5f), f = place - 0.5f - low;
        const auto texel = [&](int x, int y) {
            return glm::vec3(after[atlases[0].index(glm::ivec2(low) + glm::ivec2(x, y))]);
        };
        return glm::mix(glm::mix(texel(0, 0), texel(1, 0), f.x), glm::mix(texel(0, 1), texel(1, 1), f.x), f.y);
    }
    [[nodiscard]] glm::dvec3 mean(const std::vector<glm::vec4>& map) const {
        glm::dvec4 sum(0.0);
        for (const AtlasTexel& texel : atlases[0].texels)
            sum += double(texel.area) * glm::dvec4(glm::vec3(map[atlases[0].index(texel.at)]), 1.0f);
        return glm::dvec3(sum) / sum.w;
    }
};

class SkinDiffusion : public GpuTest {
 protected:
    void SetUp() override {
        GpuTest::SetUp();
        shaders_ = std::make_unique<gpu::ShaderLibrary>();
        shaders_->add_folder("skin", paths::root() / "modules/skin/shaders");
    }
    void TearDown() override {
        shaders_.reset();
        GpuTest::TearDown();
    }

    static Spread lit_map(const Mesh& mesh, int size, const std::function<glm::vec3(const AtlasTexel&)>& light) {
        Spread spread;
        spread.atlases = atlases_of(mesh, size);
        const Atlas& atlas = spread.atlases[0];
        EXPECT_TRUE(atlas.usable()) << atlas.problem;
        spread.before.resize(size_t(atlas.extent()) * size_t(atlas.extent()));
        for (const AtlasTexel& texel : atlas.texels)
            spread.before[atlas.index(texel.at)] = glm::vec4(light(texel), float(texel.chart));
        return spread;
    }

    Spread spread_by_taps(const Mesh& mesh, int size, const std::function<glm::vec3(const AtlasTexel&)>& light) {
        Spread spread = lit_map(mesh, size, light);
        SurfaceMaps maps(mesh, {.mesh = 1, .size = size, .technique = MapTechnique::taps}, glm::mat3(1.0f));
        auto& map = const_cast<gpu::Texture&>(maps.light());
        map.upload(0, 0, spread.before.data());
        maps.spread(*shaders_, kSkin);
        spread.after = maps.result().read();
        return spread;
    }

    Spread spread(const Mesh& mesh, int size, const std::function<glm::vec3(const AtlasTexel&)>& light,
                  const physics::DiffusionProfile& profile = kSkin, const ChunkSet* chosen = nullptr) {
        Spread spread = lit_map(mesh, size, light);
        LobeBlurs blurs(spread.atlases);
        if (chosen) blurs.choose(*chosen);
        auto& map = const_cast<gpu::Texture&>(blurs.light());
        map.upload(0, 0, spread.before.data());
        blurs.run(*shaders_, profile);
        spread.after = blurs.result().read();
        spread.plan = blurs.plan();
        return spread;
    }

    std::unique_ptr<gpu::ShaderLibrary> shaders_;
};

/// Root mean square of the error within 10 mm to both sides, a channel each.
glm::vec3 error_of(const std::function<glm::vec3(float)>& line, const std::function<glm::vec3(float)>& truth) {
    constexpr float kReach = 0.01f;
    constexpr int kSamples = 2000;
    glm::dvec3 sum(0.0);
    for (int i = 0; i < kSamples; ++i) {
        const float x = kReach * (2.0f * (float(i) + 0.5f) / float(kSamples) - 1.0f);
        const glm::dvec3 error(line(x) - truth(x));
        sum += error * error;
    }
    return glm::vec3(glm::sqrt(sum / double(kSamples)));
}

float worst(const glm::vec3& v) {
    return std::max({v.x, v.y, v.z});
}

std::string text(const glm::vec3& v) {
    return fmt::format("{:.4f} {:.4f} {:.4f}", v.x, v.y, v.z);
}

/// From where an edge is a tenth to where it is nine tenths; metres.
glm::vec3 width_of(const std::function<glm::vec3(float)>& edge) {
    const auto crossing = [&](float value, int channel) {
        float low = -0.015f, high = 0.015f;
        for (int i = 0; i < 30; ++i) (edge(0.5f * (low + high))[channel] < value ? low : high) = 0.5f * (low + high);
        return low;
    };
    glm::vec3 width;
    for (int i = 0; i < 3; ++i) width[i] = crossing(0.9f, i) - crossing(0.1f, i);
    return width;
}

TEST_F(SkinDiffusion, AKnifeEdgeAndASlitAreSpreadAsTheProfileSays) {
    struct Case {
        int size;
        float share;  ///< of the UVs' square that the sheet has
    };
    constexpr float kWidth = 0.05f;
    const glm::vec3 wanted = width_of([](float x) { return kSkin.edge(x); });
    for (const Case& c : {Case{512, 1.0f}, {256, 1.0f}, {512, 0.5f}, {128, 1.0f}}) {
        const glm::vec2 low(0.5f - 0.5f * c.share), high(0.5f + 0.5f * c.share);
        const Mesh mesh = sheet(kWidth, kWidth, low, high);
        const float texel = kWidth / (float(c.size) * c.share);
        const Spread edge =
            spread(mesh, c.size, [](const AtlasTexel& t) { return glm::vec3(t.position.x > 0.0f ? 1.0f : 0.0f); });
        const auto line = [&](const Spread& spread) {
            return [&](float x) { return spread.at(spread.atlases[0].place({0.5f + c.share * x / kWidth, 0.5f})); };
        };
        const glm::vec3 error = error_of(line(edge), [](float x) { return kSkin.edge(x); });
        const glm::vec3 width = width_of(line(edge)) / wanted;
        const float half = texel * std::max(std::round(0.0005f / texel), 1.0f);
        const Spread slit = spread(
            mesh, c.size, [&](const AtlasTexel& t) { return glm::vec3(std::abs(t.position.x) < half ? 1.0f : 0.0f); });
        const glm::vec3 slit_error =
            error_of(line(slit), [&](float x) { return kSkin.edge(x + half) - kSkin.edge(x - half); });
        std::printf("texels of %.3f mm: edge RMS %s, its width over the profile's %s; slit of %.2f mm RMS %s;",
                    1e3 * double(texel), text(error).c_str(), text(width).c_str(), 2e3 * double(half),
                    text(slit_error).c_str());
        for (const LobeBlur& blur : edge.plan.blurs) std::printf(" %d:%d", blur.level, blur.radius);
        std::printf(" (level:radius)\n");
        const bool fine = texel < 0.2e-3f;  // else coarser than what the narrow lobes spread
        EXPECT_LE(worst(error), 0.01f);
        EXPECT_LE(worst(slit_error), fine ? 0.01f : 0.02f);
        // a width of a few texels is the texels' own
        for (int i = 0; i < 3; ++i) {
            if (wanted[i] < 4.0f * texel) continue;
            EXPECT_NEAR(width[i], 1.0f, 0.03f) << i;
        }
    }
}

TEST_F(SkinDiffusion, WidthsHoldAlongAllDirectionsOfAStretchedMap) {
    // half as many texels along v as along u, and leaning by 31 degrees
    constexpr float kWidth = 0.05f;
    Mesh mesh = sheet(kWidth, kWidth, {0, 0}, {1, 1});
    for (glm::vec2& uv : mesh.uv0) uv = glm::vec2(0.15f + 0.7f * uv.x + 0.3f * (uv.y - 0.5f), 0.25f + 0.5f * uv.y);
    const auto uv_of = [](const glm::vec2& p) {
        const glm::vec2 uv = glm::vec2(p.x, -p.y) / kWidth + 0.5f;
        return glm::vec2(0.15f + 0.7f * uv.x + 0.3f * (uv.y - 0.5f), 0.25f + 0.5f * uv.y);
    };
    for (const float degrees : {0.0f, 30.0f, 60.0f, 90.0f, 120.0f, 150.0f}) {
        const glm::vec2 across(std::cos(glm::radians(degrees)), std::sin(glm::radians(degrees)));
        const auto lit = [&](const AtlasTexel& t) {
            // the share of the texel, so that the edge's place is what it should be
            const float distance = glm::dot(glm::vec2(t.position), across);
            return glm::vec3(std::clamp(0.5f + distance / 0.15e-3f, 0.0f, 1.0f));
        };
        const Spread edge = spread(mesh, 512, lit);
        EXPECT_EQ(edge.atlases[0].leaning, 1.0f);
        const auto line = [&](float x) { return edge.at(edge.atlases[0].place(uv_of(x * across))); };
        const glm::vec3 error = error_of(line, [](float x) { return kSkin.edge(x); });
        const glm::vec3 width = width_of(line) / width_of([](float x) { return kSkin.edge(x); });
        std::printf("edge at %3.0f degrees: RMS %s, width %s\n", double(degrees), text(error).c_str(),
                    text(width).c_str());
        EXPECT_LE(worst(error), 0.01f);
        EXPECT_NEAR(width.x, 1.0f, 0.03f);
    }
}

TEST_F(SkinDiffusion, LightGoesAcrossTheSeamsOfACube) {
    // one face of a metre is lit; skin's profile made wide enough for it
    const physics::DiffusionProfile wide = kSkin.scaled(30.0f);
    const Mesh mesh = unwrapped_cube();
    const Spread lit = spread(
        mesh, 300, [](const AtlasTexel& t) { return glm::vec3(t.position.x > 0.499f ? 1.0f : 0.0f); }, wide);
    const glm::dvec3 before = lit.mean(lit.before), after = lit.mean(lit.after);
    std::printf("mean before %.4f, after %s of it\n", before.x, text(glm::vec3(after / before)).c_str());
    double sum = 0.0;
    float farthest = 0.0f;
    int count = 0;
    for (const AtlasTexel& texel : lit.atlases[0].texels) {
        const glm::vec3 p = texel.position, a = glm::abs(p);
        // a strip around the middle of the lit face's edges, to where the cube's other edges begin to count
        const bool on_top = p.x > 0.499f, beside = !on_top && p.x > 0.2f;
        const float side = std::min(a.y, a.z), along = std::max(a.y, a.z);
        if (side > 0.2f || !(beside || (on_top && along > 0.2f))) continue;
        const float inside = on_top ? 0.5f - along : p.x - 0.5f;
        const float error = lit.after[lit.atlases[0].index(texel.at)].x - wide.edge(inside).x;
        sum += double(error) * double(error);
        farthest = std::max(farthest, std::abs(error));
        ++count;
    }
    const double rms = std::sqrt(sum / count);
    std::printf("across the lit face's edges, red: RMS %.4f, worst %.4f\n", rms, double(farthest));
    EXPECT_LE(rms, 0.01);
    EXPECT_LE(farthest, 0.06f);
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(after[i] / before[i], 1.0, 0.01);
}

TEST_F(SkinDiffusion, ASphereKeepsItsLightAndShowsNoSeam) {
    Mesh mesh = make_primitive(Primitive::sphere, 128);
    for (glm::vec3& position : mesh.positions) position *= 0.1f;  // 10 cm across
    for (glm::vec3 light : {glm::vec3(0, 1, 0), {1, 0, 0}, {0, 0, 1}, {0.5f, 0.6f, 0.62f}}) {
        light = glm::normalize(light);
        const auto lit = [&](const AtlasTexel& t) { return glm::vec3(std::max(glm::dot(t.normal, light), 0.0f)); };
        const Spread ball = spread(mesh, 512, lit);
        const glm::dvec3 ratio = ball.mean(ball.after) / ball.mean(ball.before);
        // what should depend on the angle to the light alone
        std::array<glm::dvec2, 90> sums{};
        const auto bin = [&](const AtlasTexel& t) {
            return size_t(
                std::min(89.0f, 0.5f * glm::degrees(std::acos(glm::clamp(glm::dot(t.normal, light), -1.0f, 1.0f)))));
        };
        const auto value = [&](const AtlasTexel& t) {
            return double(ball.after[ball.atlases[0].index(t.at)].x - std::max(glm::dot(t.normal, light), 0.0f));
        };
        for (const AtlasTexel& t : ball.atlases[0].texels) sums[bin(t)] += glm::dvec2(value(t), 1.0);
        double at_seam = 0.0, anywhere = 0.0;
        for (const AtlasTexel& t : ball.atlases[0].texels) {
            if (std::abs(t.normal.y) > 0.9f) continue;
            const double error = std::abs(value(t) - sums[bin(t)].x / sums[bin(t)].y);
            const bool near = t.at.x < kGutterTexels + 8 || t.at.x > 512 + kGutterTexels - 8;
            (near ? at_seam : anywhere) = std::max(near ? at_seam : anywhere, error);
        }
        std::printf(
            "light from (%.1f %.1f %.1f): mean after over before %s; red off the mean at its angle: %.4f at the seam, "
            "%.4f elsewhere\n",
            double(light.x), double(light.y), double(light.z), text(glm::vec3(ratio)).c_str(), at_seam, anywhere);
        for (int i = 0; i < 3; ++i) EXPECT_NEAR(ratio[i], 1.0, 0.01);
        EXPECT_LE(at_seam, 0.02);
    }
}

TEST_F(SkinDiffusion, HablesTapsAreNearAKnifeEdge) {
    constexpr float kWidth = 0.05f;
    const Mesh mesh = sheet(kWidth, kWidth, {0, 0}, {1, 1});
    for (const int size : {512, 256, 128}) {
        glm::dvec3 squares(0.0);
        glm::vec3 farthest(0.0f), width(0.0f);
        constexpr int kDirections = 12;
        for (int i = 0; i < kDirections; ++i) {
            const float angle = glm::radians(360.0f * float(i) / kDirections);
            const glm::vec2 across(std::cos(angle), std::sin(angle));
            const Spread edge = spread_by_taps(mesh, size, [&](const AtlasTexel& t) {
                return glm::vec3(glm::dot(glm::vec2(t.position), across) > 0.0f ? 1.0f : 0.0f);
            });
            const auto line = [&](float x) {
                return edge.at(edge.atlases[0].place(glm::vec2(x * across.x, -x * across.y) / kWidth + 0.5f));
            };
            const glm::vec3 error = error_of(line, [](float x) { return kSkin.edge(x); });
            squares += glm::dvec3(error) * glm::dvec3(error) / double(kDirections);
            farthest = glm::max(farthest, error);
        }
        const glm::vec3 mean(glm::sqrt(squares));
        std::printf("texels of %.3f mm: edge RMS over all directions %s, worst direction %s\n",
                    1e3 * double(kWidth) / size, text(mean).c_str(), text(farthest).c_str());
        EXPECT_LE(worst(farthest), 0.05f);
        EXPECT_GE(worst(mean), 0.001f);  // thirteen taps are not the profile
    }
}

TEST(SkinHable, TapsAreNearOtherProfilesToo) {
    // Jensen's skin1 and wax, roughly, and skin at twice the size
    const physics::DiffusionProfile wide{{{0.05e-6f, {0.2f, 0.3f, 0.5f}},
                                          {1.0e-6f, {0.3f, 0.5f, 0.45f}},
                                          {9.0e-6f, {0.4f, 0.19f, 0.05f}},
                                          {40.0e-6f, {0.1f, 0.01f, 0.0f}}}};
    const physics::DiffusionProfile even{{{4.0e-6f, glm::vec3(1.0f)}}};
    for (const physics::DiffusionProfile& profile : {kSkin, kSkin.scaled(2.0f), wide, even}) {
        const auto taps = hable_taps(profile);
        glm::vec3 sum(0.0f);
        for (const HableTap& tap : taps) sum += tap.weight;
        glm::dvec3 squares(0.0);
        constexpr int kDirections = 12, kSamples = 400;
        const float reach = 4.0f * std::sqrt(0.5f * profile.mean_square().x);
        for (int i = 0; i < kDirections * kSamples; ++i) {
            const float angle = glm::radians(360.0f * float(i % kDirections) / kDirections);
            const float x = reach * (2.0f * float(i / kDirections) / kSamples - 1.0f);
            const glm::dvec3 error(hable_edge(taps, {std::cos(angle), std::sin(angle)}, x) - profile.edge(x));
            squares += error * error / double(kDirections * kSamples);
        }
        const glm::vec3 rms(glm::sqrt(squares));
        std::printf("taps against a profile of %zu lobes: edge RMS %s\n", profile.lobes.size(), text(rms).c_str());
        for (int i = 0; i < 3; ++i) EXPECT_NEAR(sum[i], 1.0f, 1e-4f);
        EXPECT_LE(worst(rms), profile.lobes.size() > 1 ? 0.05f : 0.07f);
    }
}

TEST_F(SkinDiffusion, HablesTapsAreAsWideInAllMaps) {
    // means over all directions, since the taps have a pattern
    const auto width_at = [&](int size, float share) {
        constexpr float kWidth = 0.05f;
        const Mesh mesh = sheet(kWidth, kWidth, glm::vec2(0.5f - 0.5f * share), glm::vec2(0.5f + 0.5f * share));
        double sum = 0.0;
        for (int i = 0; i < 8; ++i) {
            const float angle = glm::radians(45.0f * float(i));
            const glm::vec2 across(std::cos(angle), std::sin(angle));
            const Spread edge = spread_by_taps(mesh, size, [&](const AtlasTexel& t) {
                return glm::vec3(glm::dot(glm::vec2(t.position), across) > 0.0f ? 1.0f : 0.0f);
            });
            // the mean distance of light from the edge: the width of any response that ends
            for (int j = 0; j < 1000; ++j) {
                const float x = 0.008f * (float(j) + 0.5f) / 1000.0f;
                const auto at = [&](float d) {
                    const glm::vec2 uv = share * glm::vec2(d * across.x, -d * across.y) / kWidth + 0.5f;
                    return edge.at(edge.atlases[0].place(uv)).x;
                };
                sum += double(1.0f - at(x) + at(-x)) * 0.008 / 1000.0 / 16.0;
            }
        }
        return sum;
    };
    const double fine = width_at(512, 1.0f), half = width_at(512, 0.5f), small = width_at(256, 1.0f);
    std::printf("mean distance from the edge, red, mm: %.4f; half the UVs %.4f; half the map %.4f\n", 1e3 * fine,
                1e3 * half, 1e3 * small);
    EXPECT_NEAR(half / fine, 1.0, 0.03);
    EXPECT_NEAR(small / fine, 1.0, 0.03);
}

TEST_F(SkinDiffusion, WhatIsNotChosenDoesNotShow) {
    Mesh mesh = make_primitive(Primitive::sphere, 64);
    for (glm::vec3& position : mesh.positions) position *= 0.1f;
    const glm::vec3 eye(0.05f, 0.1f, 0.3f), light = glm::normalize(glm::vec3(1.0f, 0.3f, 0.2f));
    const auto lit = [&](const AtlasTexel& t) { return glm::vec3(std::max(glm::dot(t.normal, light), 0.0f)); };
    const Spread all = spread(mesh, 256, lit);
    AtlasChunks chunks(all.atlases[0]);
    const ChunkSet seen = chunks.seen_from(glm::vec4(eye, 1.0f));
    const ChunkSet chosen = chunks.grown(seen, 3.5f * std::sqrt(kSkin.lobes.back().variance_m2));
    EXPECT_TRUE(holds(chosen, seen));
    EXPECT_FALSE(holds(seen, chosen));
    const auto in = [&](const ChunkSet& set, size_t texel) {
        const std::vector<size_t> begins = chunk_begins(all.atlases[0]);
        return set[size_t(std::ranges::upper_bound(begins, texel) - begins.begin()) - 1] != 0;
    };
    const std::vector<AtlasTexel>& texels = all.atlases[0].texels;
    std::map<std::pair<int, int>, bool> dark;
    for (size_t i = 0; i < texels.size(); ++i) dark[{texels[i].at.x, texels[i].at.y}] = !in(chosen, i);
    const Spread part = spread(
        mesh, 256,
        [&](const AtlasTexel& t) {
            return dark[{t.at.x, t.at.y}] ? glm::vec3(0.0f) : lit(t);
        },
        kSkin, &chosen);
    float error = 0.0f;
    size_t count = 0;
    for (size_t i = 0; i < texels.size(); ++i) {
        if (glm::dot(texels[i].face, eye - texels[i].position) <= 0.0f) continue;
        ++count;
        EXPECT_TRUE(in(seen, i));
        const size_t at = all.atlases[0].index(texels[i].at);
        error = std::max(error, glm::distance(glm::vec3(all.after[at]), glm::vec3(part.after[at])));
    }
    std::printf("%zu of %zu texels are seen; worst difference there %.5f\n", count, texels.size(), double(error));
    EXPECT_LT(error, 2e-3f);
}

}  // namespace
}  // namespace tyndall::skin
