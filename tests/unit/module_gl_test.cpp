// Reloading a module that draws, between frames.

#include <gmock/gmock.h>

#include "module_fixture.h"
#include "renderer_fixture.h"

namespace tyndall {
namespace {

class ModuleDrawTest : public RendererTest {
 protected:
    void SetUp() override {
        RendererTest::SetUp();
        manager_ =
            std::make_unique<ModuleManager>(ModuleHost{registry_, extractors_, *settings_, {&world_}, renderer_.get()},
                                            folder_.path(), paths::root() / "tests" / "unit" / "modules");
        scene_ = test::spheres();
    }
    void TearDown() override {
        manager_.reset();
        RendererTest::TearDown();
    }
    void put(const std::string& generation) { put_module(folder_.path(), generation, "painter"); }
    glm::vec3 corner() {
        const Image image = render(scene_, {64, 36});
        return {image.at(0, 0, 0), image.at(0, 0, 1), image.at(0, 0, 2)};
    }

    TemporaryFolder folder_;
    ComponentRegistry registry_;
    Extractors extractors_;
    World world_{registry_};
    std::unique_ptr<ModuleManager> manager_;
    RenderScene scene_;
};

TEST_F(ModuleDrawTest, ThePictureFollowsTheModule) {
    const glm::vec3 plain = corner();
    const glm::vec3 behind = plain * 0.25f;  // what the painter's seam lets through
    put("1");
    ASSERT_TRUE(manager_->load("painter"));
    const auto expect_picture = [&](const char* when, glm::vec3 expected) {
        const glm::vec3 seen = corner();
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(seen[c], expected[c], 0.002f * expected[c] + 0.01f) << when << c;
    };
    expect_picture("version 1", behind + glm::vec3(8, 1, 0));
    put("2");
    ASSERT_TRUE(manager_->reload("painter"));
    expect_picture("version 2", behind + glm::vec3(0, 1, 8));
    std::filesystem::resize_file(folder_.path() / "painter.so", 3000);
    ASSERT_FALSE(manager_->reload("painter"));
    expect_picture("broken build", behind + glm::vec3(0, 1, 8));
    put("1");
    ASSERT_TRUE(manager_->reload("painter"));
    expect_picture("version 1 again", behind + glm::vec3(8, 1, 0));
    manager_->unload("painter");
    expect_picture("without", plain);
    EXPECT_EQ(mappings_of("painter"), 0);
}

TEST_F(ModuleDrawTest, ManyReloadsBetweenFramesLeaveNoObjects) {
    put("1");
    ASSERT_TRUE(manager_->load("painter"));
    const glm::vec3 first = corner();
    const gpu::Alive before = gpu::alive();
    for (int i = 0; i < 4; ++i) {
        put(i % 2 == 0 ? "2" : "1");
        ASSERT_TRUE(manager_->reload("painter"));
        (void)corner();
    }
    EXPECT_EQ(corner(), first);
    EXPECT_EQ(gpu::alive(), before);
}

TEST_F(ModuleDrawTest, ATargetOfThePassMayBeOnScreenMeanwhile) {
    put("1");
    ASSERT_TRUE(manager_->load("painter"));
    (void)corner();
    renderer_->show("paint_kept");
    (void)corner();
    put("2");
    ASSERT_TRUE(manager_->reload("painter"));
    (void)corner();
    manager_->unload("painter");
    renderer_->render(scene_, {64, 36});
    EXPECT_THAT(renderer_->problems(), testing::HasSubstr("paint_kept"));
    renderer_->show("");
    EXPECT_GT(corner().x, 0.0f);
}

}  // namespace
}  // namespace tyndall
