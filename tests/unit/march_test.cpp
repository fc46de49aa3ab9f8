// The ray march below full resolution, in thick fog, in the dark and on 8 bits.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "image/compare.h"
#include "march_fixture.h"

namespace tyndall {
namespace {

struct Errors {
    double inside = 0.0, outside = 0.0, worst = 0.0;
};

double srgb(double linear) {
    return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1.0 / 2.4) - 0.055;
}

/// Pixels within 3 of a jump of the depth.
std::vector<bool> silhouettes(const Image& depth) {
    std::vector<bool> near(size_t(depth.width * depth.height));
    const auto jumps = [&](int x, int y) {
        const float d = depth.at(x, y, 0);
        for (const glm::ivec2 step : {glm::ivec2(1, 0), glm::ivec2(0, 1)}) {
            const float other =
                depth.at(std::min(x + step.x, depth.width - 1), std::min(y + step.y, depth.height - 1), 0);
            if (std::abs(other - d) > 0.05f * std::max(d, other)) return true;
        }
        return false;
    };
    for (int y = 0; y < depth.height; ++y)
        for (int x = 0; x < depth.width; ++x)
            if (jumps(x, y))
                for (int j = std::max(y - 2, 0); j <= std::min(y + 3, depth.height - 1); ++j)
                    for (int i = std::max(x - 2, 0); i <= std::min(x + 3, depth.width - 1); ++i)
                        near[size_t(j * depth.width + i)] = true;
    return near;
}

/// Relative squared errors, as relMSE, inside the mask and outside.
Errors compare(const Image& truth, const Image& test, const std::vector<bool>& mask) {
    double mean = 0.0;
    for (int y = 0; y < truth.height; ++y)
        for (int x = 0; x < truth.width; ++x) mean += truth.at(x, y, 1) / double(truth.width * truth.height);
    Errors errors;
    double inside = 0.0, outside = 0.0;
    for (int y = 0; y < truth.height; ++y)
        for (int x = 0; x < truth.width; ++x) {
            const double r = truth.at(x, y, 1), d = test.at(x, y, 1) - r;
            const double error = d * d / (r * r + 0.01 * mean * mean);
            const bool in = mask[size_t(y * truth.width + x)];
            (in ? errors.inside : errors.outside) += error;
            (in ? inside : outside) += 1.0;
            errors.worst = std::max(errors.worst, error);
        }
    errors.inside /= inside;
    errors.outside /= outside;
    return errors;
}

/// By how many pixels to the right (of the picture, and up) `test` lies beside `truth`: least squares of test = truth -
/// shift * gradient.
glm::dvec2 shift_of(const Image& truth, const Image& test) {
    glm::dvec2 products(0.0), squares(0.0);
    for (int y = 1; y + 1 < truth.height; ++y)
        for (int x = 1; x + 1 < truth.width; ++x) {
            const double d = test.at(x, y, 1) - truth.at(x, y, 1);
            const glm::dvec2 gradient(0.5 * (truth.at(x + 1, y, 1) - truth.at(x - 1, y, 1)),
                                      0.5 * (truth.at(x, y - 1, 1) - truth.at(x, y + 1, 1)));
            products -= d * gradient;
            squares += gradient * gradient;
        }
    return products / squares;
}

TEST_F(MarchTest, LowerResolutionsHaveNoHaloAtSilhouettes) {
    load({{"/render/participating_media/steps", "256"}, {"/render/participating_media/filter", "false"}});
    const Image truth = frame();
    const std::vector<bool> mask = silhouettes(frame("scene_depth"));
    struct Case {
        const char *resolution, *steps;
        double most, worst;
    };
    for (const Case& c : {Case{"full", "12", 0.001, 0.5}, Case{"half", "6", 0.002, 0.5}, Case{"half", "12", 0.001, 0.5},
                          Case{"quarter", "6", 0.004, 1.0}, Case{"quarter", "12", 0.003, 1.0}}) {
        load({{"/render/participating_media/resolution", quoted(c.resolution)},
              {"/render/participating_media/steps", c.steps}});
        const Image test = frame();
        const Errors errors = compare(truth, test, mask);
        const LinearDifference whole = compare_linear(truth, test);
        std::printf("%s, %s steps: relMSE %.6f, near silhouettes %.6f, elsewhere %.6f, worst %.3f, mean ratio %.4f\n",
                    c.resolution, c.steps, whole.relative_mse, errors.inside, errors.outside, errors.worst,
                    whole.mean_ratio);
        EXPECT_LT(whole.relative_mse, c.most);
        if (c.resolution != std::string("full")) {
            EXPECT_LE(errors.inside, 2.0 * errors.outside);
        }
        EXPECT_LT(errors.worst, c.worst) << "as much as the light itself";
        EXPECT_NEAR(whole.mean_ratio, 1.0, 0.005);
    }
}

TEST_F(MarchTest, LowerResolutionsShiftNothing) {
    const Assignments fine{{"/render/participating_media/steps", "64"},
                           {"/render/participating_media/filter", "false"}};
    load(fine);
    const Image truth = frame();
    for (const char* resolution : {"half", "quarter"}) {
        Assignments changes = fine;
        changes.emplace_back("/render/participating_media/resolution", quoted(resolution));
        load(changes);
        const glm::dvec2 shift = shift_of(truth, frame());
        std::printf("%s: shifted by %.4f, %.4f pixels\n", resolution, shift.x, shift.y);
        EXPECT_LT(glm::length(shift), 0.05);
    }
}

TEST_F(MarchTest, RaysEndInThickFogWhereNothingIsSeen) {
    const auto thick = [](const char* least, const char* steps) {
        return Assignments{
            {"/entities/Spot", R"({ "name": "Spot", "transform": { "translation": [0, 9, 2], "look_at": [0, 0, 0] },
                                                   "directional_light": { "illuminance_lux": 10 } })"},
            {"/entities/Fog/medium/scattering_per_m", "[1.5, 1.5, 1.5]"},
            {"/render/participating_media/least_transmittance", least},
            {"/render/participating_media/filter", "false"},
            {"/render/participating_media/steps", steps}};
    };
    size_ = {160, 90};
    load(thick("0", "1024"));
    const Image truth = frame();
    load(thick("0.0001", "1024"));
    const LinearDifference lost = compare_linear(truth, frame());
    load(thick("0.0001", "12"));
    const LinearDifference with = compare_linear(truth, frame());
    load(thick("0", "12"));
    const LinearDifference without = compare_linear(truth, frame());
    std::printf("lost: relMSE %.2e, mean %.5f; 12 steps: relMSE %.5f, without it %.5f\n", lost.relative_mse,
                lost.mean_ratio, with.relative_mse, without.relative_mse);
    EXPECT_LT(lost.relative_mse, 1e-6);
    EXPECT_NEAR(lost.mean_ratio, 1.0, 0.001);
    EXPECT_LT(with.relative_mse, 0.7 * without.relative_mse);
}

/// Light of several sources, some of them without a place: a lamp, the sky, the fog's own glow.
TEST_F(MarchTest, LowerResolutionsKeepTheGlow) {
    const auto glowing = [](const char* resolution) {
        return Assignments{
            {"/entities/Small plate", R"({ "name": "Small plate", "sky": { "radiance_cd_m2": [0.02, 0.03, 0.05] } })"},
            {"/entities/Fog/medium/emission_cd_m2_per_m", "[0.01, 0.005, 0]"},
            {"/render/participating_media/steps", "24"},
            {"/render/participating_media/resolution", quoted(resolution)}};
    };
    size_ = {160, 90};
    load(glowing("full"));
    const Image truth = frame();
    for (const char* resolution : {"half", "quarter"}) {
        load(glowing(resolution));
        const LinearDifference difference = compare_linear(truth, frame());
        std::printf("%s: relMSE %.6f, mean ratio %.4f\n", resolution, difference.relative_mse, difference.mean_ratio);
        EXPECT_LT(difference.relative_mse, 0.002);
        EXPECT_NEAR(difference.mean_ratio, 1.0, 0.005);
    }
}

TEST_F(MarchTest, WhatIsSkippedIsDark) {
    double error[2]{};
    for (const bool skip : {false, true}) {
        Image fine;
        for (const char* steps : {"512", "6"}) {
            load({{"/render/participating_media/filter", "false"},
                  {"/render/participating_media/steps", steps},
                  {"/render/participating_media/shadow_mips", skip && steps[0] == '6' ? "true" : "false"}});
            if (steps[0] == '5')
                fine = frame();
            else
                error[skip] = compare_linear(fine, frame()).relative_mse;
        }
        if (!skip) continue;
        load({{"/render/participating_media/filter", "false"},
              {"/render/participating_media/steps", "512"},
              {"/render/participating_media/shadow_mips", "true"}});
        const LinearDifference same = compare_linear(fine, frame());
        std::printf("512 steps: relMSE %.2e, mean ratio %.6f; 6 steps: %.5f, without %.5f\n", same.relative_mse,
                    same.mean_ratio, error[1], error[0]);
        EXPECT_LT(same.relative_mse, 1e-4);
        EXPECT_NEAR(same.mean_ratio, 1.0, 1e-4);
        EXPECT_LT(error[1], error[0]);
    }
}

/// What the display is sent of a smooth glow, against its values before they were rounded to 8 bits.
TEST_F(MarchTest, EightBitsShowNoBands) {
    const auto glow = [](const char* dither) {
        return Assignments{{"/render/image/antialiasing", R"("none")"},
                           {"/render/image/dither", dither},
                           {"/render/participating_media/steps", "128"},
                           {"/render/participating_media/jitter", "false"},
                           {"/entities/Camera/transform/translation", "[3, 4, 8]"},
                           {"/entities/Camera/transform/look_at", "[30, 4, -1]"},
                           {"/entities/Spot/spot_light/intensity_cd", "1000"},
                           {"/entities/Spot/spot_light/outer_angle_deg", "89"},
                           {"/entities/Spot/spot_light/shadow/enabled", "false"}};
    };
    constexpr int kBlock = 16;
    double mean_error[2]{}, rest[2]{};
    for (const bool dither : {false, true}) {
        load(glow(dither ? "true" : "false"));
        const Image exact = frame("radiance"), shown = frame("display");
        double blocks = 0.0;
        for (int top = 0; top + kBlock <= size_.y; top += kBlock)
            for (int left = 0; left + kBlock <= size_.x; left += kBlock) {
                double sum = 0.0, lag = 0.0, square = 0.0;
                for (int y = top; y < top + kBlock; ++y)
                    for (int x = left; x < left + kBlock; ++x) {
                        const auto error = [&](int column) {
                            return 255.0 *
                                   (double(shown.at(column, y, 1)) - srgb(std::min(exact.at(column, y, 1), 1.0f)));
                        };
                        sum += error(x);
                        square += error(x) * error(x);
                        if (x > left) lag += error(x) * error(x - 1);
                        EXPECT_LE(std::abs(error(x)), dither ? 1.5 : 0.51);
                    }
                const double level = srgb(std::min(exact.at(left, top, 1), 1.0f));
                if (level < 0.02 || level > 0.98) continue;  // dither leaves black and white alone
                mean_error[dither] = std::max(mean_error[dither], std::abs(sum) / (kBlock * kBlock));
                rest[dither] += lag / square;
                blocks += 1.0;
            }
        rest[dither] /= blocks;
    }
    std::printf(
        "worst mean of a block: %.4f of a step, without dither %.4f; correlation of neighbours' errors %.3f, %.3f\n",
        mean_error[1], mean_error[0], rest[1], rest[0]);
    EXPECT_LT(mean_error[1], 0.1);
    EXPECT_GT(rest[0], 0.3) << "a gradient too steep for bands";
    EXPECT_LT(rest[1], 0.1) << "errors of one sign side by side are a band";
}

}  // namespace
}  // namespace tyndall
