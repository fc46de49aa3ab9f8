#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <limits>

#include "app/camera_control.h"
#include "app/capture_file.h"
#include "app/expectations.h"
#include "app/walker.h"
#include "core/error.h"

namespace tyndall {
namespace {

void add_box(Walker& walker, const glm::vec3& low, const glm::vec3& high) {
    std::array<glm::vec3, 8> corners;
    for (size_t i = 0; i < 8; ++i)
        corners[i] = {(i & 1) != 0 ? high.x : low.x, (i & 2) != 0 ? high.y : low.y, (i & 4) != 0 ? high.z : low.z};
    static constexpr std::array<uint32_t, 36> kIndices{0, 1, 3, 0, 3, 2, 4, 6, 7, 4, 7, 5, 0, 4, 5, 0, 5, 1,
                                                       2, 3, 7, 2, 7, 6, 0, 2, 6, 0, 6, 4, 1, 5, 7, 1, 7, 3};
    walker.add_collider(corners, kIndices);
}

class Walking : public testing::Test {
 protected:
    void SetUp() override {
        add_box(walker_, {-10, -1, -10}, {10, 0, 10});
        walker_.place({0, 3, 0});
    }
    glm::vec3 walk(const glm::vec3& velocity, float seconds) {
        glm::vec3 eye{0.0f};
        for (float t = 0.0f; t < seconds; t += 1.0f / 60.0f) eye = walker_.walk(velocity, 1.0f / 60.0f);
        return eye;
    }
    Walker walker_;
};

TEST_F(Walking, StandsAtEyeHeightAndCoversTheDistance) {
    EXPECT_NEAR(walk({0, 0, 0}, 0.5f).y, 1.65f, 0.08f);
    const glm::vec3 eye = walk({1, 0, 0}, 2.0f);
    EXPECT_NEAR(eye.x, 2.0f, 0.1f);
    EXPECT_NEAR(eye.y, 1.65f, 0.08f);
}

TEST_F(Walking, StopsAtAWallAndSlidesAlongIt) {
    add_box(walker_, {2, 0, -10}, {2.2f, 3, 10});
    const glm::vec3 eye = walk({1.5f, 0, 1.0f}, 3.0f);
    EXPECT_LT(eye.x, 2.0f - 0.2f);
    EXPECT_GT(eye.x, 1.3f);
    EXPECT_GT(eye.z, 2.0f);
}

TEST_F(Walking, ClimbsAStepButNoTable) {
    add_box(walker_, {1, 0, -10}, {10, 0.18f, 10});
    EXPECT_NEAR(walk({1, 0, 0}, 2.5f).y, 1.65f + 0.18f, 0.1f);
    add_box(walker_, {-3, 0, -10}, {-2, 0.8f, 10});
    walker_.place({0, 3, 0});
    EXPECT_GT(walk({-1, 0, 0}, 4.0f).x, -2.0f);
}

TEST_F(Walking, FlightDoesNotPassWalls) {
    add_box(walker_, {2, 0, -10}, {2.2f, 3, 10});
    const glm::vec3 eye = walker_.fly({0, 1.5f, 0}, {5, 0, 0});
    EXPECT_LT(eye.x, 2.0f);
    EXPECT_GT(eye.x, 1.5f);
    EXPECT_EQ(walker_.fly({0, 1.5f, 0}, {-1, 0, 0}), glm::vec3(-1, 1.5f, 0));
}

TEST(CameraControlTest, KeepsAPlacementAndLooksNoFurtherThanUp) {
    Walker nowhere;
    CameraControl control;
    control.set_mode(CameraMode::fly, nowhere);
    const glm::mat4 placed = glm::inverse(glm::lookAt(glm::vec3(1, 2, 3), glm::vec3(4, 1, -2), glm::vec3(0, 1, 0)));
    control.set(placed, nowhere);
    for (int column = 0; column < 4; ++column)
        EXPECT_LT(glm::distance(control.transform()[column], placed[column]), 1e-5f) << column;
    control.update({.look_rad = {0, 10}}, 0.1f, nowhere);
    EXPECT_GT(-control.transform()[2].y, 0.99f);
    EXPECT_GT(control.transform()[1].y, 0.0f) << "not upside down";
}

class CaptureFiles : public testing::Test {
 protected:
    void SetUp() override {
        file_ = std::filesystem::temp_directory_path() / ("tyndall_capture_" + std::to_string(getpid()) + ".json");
    }
    void TearDown() override { std::filesystem::remove(file_); }
    std::string problems_of(const std::string& text) {
        std::ofstream(file_) << text;
        try {
            (void)load_capture(file_);
        } catch (const Error& error) {
            return error.what();
        }
        return {};
    }
    std::filesystem::path file_;
};

TEST_F(CaptureFiles, AreReadAndChecked) {
    EXPECT_EQ(problems_of(R"({"tyndall_capture": 1, "scene": "s.json"})"), "");
    const std::string wrong = problems_of(
        R"({"tyndall_capture": 1, "scene": "s.json", "variants": [{"name": "plain"}, {"name": "plain"}], "expect": [{"of": "plian"}]})");
    EXPECT_NE(wrong.find("two variants are named 'plain'"), std::string::npos) << wrong;
    EXPECT_NE(wrong.find("/expect/0: unknown variant 'plian'"), std::string::npos) << wrong;
    EXPECT_NE(wrong.find("did you mean 'plain'?"), std::string::npos) << wrong;
    EXPECT_EQ(problems_of(R"({"tyndall_capture": 1, "scene)").find("no scene is named"), std::string::npos);
}

CapturedPicture grey(float value) {
    CapturedPicture picture{Image(16, 16, 3, Image::Type::f32), Image(16, 16, 3, Image::Type::u8)};
    for (float& v : picture.radiance.floats()) v = value;
    return picture;
}

Verdict judged(const Expectation& wanted, const CapturedPicture& a, const CapturedPicture& b) {
    CaptureFile capture;
    capture.expect = {wanted};
    return judge(capture, {{"a", a}, {"b", b}}).front();
}

TEST(Expectations, HoldFailAndSkip) {
    using Outcome = Verdict::Outcome;
    const Expectation twice{.of = "a", .equals = "b", .scale = 2.0f, .max_relmse = 1e-9f};
    EXPECT_EQ(judged(twice, grey(2), grey(1)).outcome, Outcome::held);
    EXPECT_EQ(judged(twice, grey(2.1f), grey(1)).outcome, Outcome::failed);
    EXPECT_EQ(judged(twice, grey(std::numeric_limits<float>::quiet_NaN()), grey(1)).outcome, Outcome::failed);
    const Expectation dark{.of = "a", .mean_between = {0.0f, 0.5f}};
    EXPECT_EQ(judged(dark, grey(0.4f), grey(1)).outcome, Outcome::held);
    EXPECT_EQ(judged(dark, grey(0.6f), grey(1)).outcome, Outcome::failed);
    setenv("TYNDALL_REFERENCES", "/nowhere/at/all", 1);
    EXPECT_EQ(judged({.of = "a", .reference = "references:x.exr"}, grey(1), grey(1)).outcome, Outcome::skipped);
    unsetenv("TYNDALL_REFERENCES");
}

}  // namespace
}  // namespace tyndall
