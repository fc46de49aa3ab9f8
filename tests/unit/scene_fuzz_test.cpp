#include <gtest/gtest.h>

#include <random>

#include "core/log.h"
#include "scene_test_types.h"

namespace tyndall::scene_test {
namespace {

/// Loads a text, and when that works saves it again; anything but success or an Error with a message is a failure.
bool loads(const std::string& text) {
    Stage stage;
    try {
        SceneFile scene = stage.load(text);
        scene.update(stage.world, stage.settings, stage.options);
        EXPECT_EQ(scene.text(), text);
        return true;
    } catch (const Error& error) {
        EXPECT_STRNE(error.what(), "");
        EXPECT_FALSE(error.diagnostics().empty());
        return false;
    }
}

class SceneFuzz : public testing::Test {
 protected:
    void SetUp() override { log::set_level(log::Level::error); }
    void TearDown() override { log::set_level(log::Level::info); }
};

TEST_F(SceneFuzz, TruncatedAnywhereItIsAnError) {
    const std::string sample(kSample);
    const size_t whole = sample.find_last_of('}') + 1;
    for (size_t length = 0; length <= sample.size(); ++length)
        EXPECT_EQ(loads(sample.substr(0, length)), length >= whole) << "first " << length << " bytes";
}

TEST_F(SceneFuzz, MutatedItIsAnErrorOrAScene) {
    std::mt19937 random(20261122);
    const std::string sample(kSample);
    const std::vector<std::string> pieces = {"{",
                                             "}",
                                             "[",
                                             "]",
                                             ",",
                                             ":",
                                             "\"",
                                             "-",
                                             "0",
                                             "1e39",
                                             "null",
                                             "true",
                                             "\\",
                                             "\n",
                                             "\xff",
                                             std::string(1, '\0'),
                                             "\"parent\": \"Dust\"",
                                             "\"preset\": \"x\"",
                                             "\"name\": \"Dust\"",
                                             "[[[[[[[[",
                                             "\"look_at\": [0, 0, 0]",
                                             "1e-50"};
    size_t accepted = 0;
    for (int i = 0; i < 20000; ++i) {
        std::string text = sample;
        for (size_t change = 0; change < 1 + random() % 4; ++change) {
            const size_t at = random() % text.size();
            switch (random() % 4) {
                case 0:
                    text[at] = static_cast<char>(random() % 256);
                    break;
                case 1:
                    text.erase(at, random() % 20);
                    break;
                case 2:
                    text.insert(at, pieces[random() % pieces.size()]);
                    break;
                default:
                    text.insert(at, text.substr(random() % text.size(), random() % 60));
            }
        }
        accepted += loads(text) ? 1 : 0;
    }
    EXPECT_GT(accepted, 100u) << "the mutations are too wild to reach what comes after parsing";
}

}  // namespace
}  // namespace tyndall::scene_test
