// The ray march below full resolution, from frame to frame, and on 8 bits.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <functional>

#include "app/engine.h"
#include "core/paths.h"
#include "gpu_fixture.h"
#include "image/compare.h"
#include "renderer_fixture.h"

namespace tyndall {
namespace {

constexpr glm::ivec2 kSize{320, 180};

struct Errors {
    double inside = 0.0, outside = 0.0, worst = 0.0;
};

std::string quoted(const std::string& text) {
    return '"' + text + '"';
}

class MarchTest : public RendererTest {
 protected:
    void TearDown() override {
        EXPECT_EQ(engine_->problems(), "");
        engine_.reset();
        RendererTest::TearDown();
    }
    void load(const Assignments& changes) {
        if (!engine_) engine_ = std::make_unique<Engine>(true);
        engine_->load_scene(paths::root() / "assets/scenes/s1_fog_spot.json", changes);
        scene_ = engine_->extract();
        frame_ = 0;
    }
    Image frame(std::string_view target = "media_in_scatter") {
        scene_.camera_cut = frame_ == 0;
        scene_.frame = frame_++;
        engine_->renderer().retain({std::string(target)});
        engine_->renderer().render(scene_, kSize);
        return picture(*engine_->renderer().target(target));
    }
    std::unique_ptr<Engine> engine_;
    RenderScene scene_;
    uint64_t frame_ = 0;
};

/// Pixels within 3 of a jump of the depth.
std::vector<bool> silhouettes(const Image& depth) {
    std::vector<bool> near(size_t(depth.width * depth.height));
    const auto jumps = [&](int x, int y) {
        const float d = depth.at(x, y, 0);
        for (const glm::ivec2 step : {glm::ivec2(1, 0), glm::ivec2(0, 1)}) {
            const float other = depth.at(std::min(x + step.x, depth.width - 1), std::min(y + step.y, depth.height - 1), 0);
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

/// By how many pixels to the right (of the picture, and up) `test` lies beside `truth`: least squares of test = truth - shift * gradient.
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
        if (c.resolution != std::string("full")) EXPECT_LE(errors.inside, 2.0 * errors.outside);
        EXPECT_LT(errors.worst, c.worst) << "as much as the light itself";
        EXPECT_NEAR(whole.mean_ratio, 1.0, 0.005);
    }
}

TEST_F(MarchTest, LowerResolutionsShiftNothing) {
    const Assignments fine{{"/render/participating_media/steps", "64"}, {"/render/participating_media/filter", "false"}};
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

}  // namespace
}  // namespace tyndall
