#include <epoxy/gl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <glm/vec4.hpp>
#include <memory>

#include "core/error.h"
#include "gpu/gpu.h"
#include "platform/context.h"
#include "platform/window.h"

namespace tyndall::platform {
namespace {

TEST(Headless, GivesACoreContextWithoutADisplay) {
    const auto context = create_headless_context({.debug = true});
    const GlInfo& info = context->gl_info();
    EXPECT_GE(info.major * 10 + info.minor, 45);
    EXPECT_GE(info.max_colour_targets, 8);
    EXPECT_GE(info.max_texture_size, 16384);
    EXPECT_NE(info.text().find(info.renderer), std::string::npos);
    GLint profile = 0;
    glGetIntegerv(GL_CONTEXT_PROFILE_MASK, &profile);
    EXPECT_EQ(profile, GL_CONTEXT_CORE_PROFILE_BIT);
}

TEST(Headless, DriversComplaintsAreKeptOnce) {
    const auto context = create_headless_context({.debug = true});
    EXPECT_TRUE(context->take_debug_messages().empty());
    glBindTextureUnit(0, 12345);  // no such texture
    const auto messages = context->take_debug_messages();
    ASSERT_EQ(messages.size(), 1u);
    EXPECT_NE(messages[0].find("glBindTextureUnit"), std::string::npos) << messages[0];
    EXPECT_TRUE(context->take_debug_messages().empty());
}

TEST(Headless, TwoContextsTakeTurns) {
    const auto first = create_headless_context();
    GLuint texture = 0;
    glCreateTextures(GL_TEXTURE_2D, 1, &texture);
    {
        const auto second = create_headless_context();
        EXPECT_FALSE(glIsTexture(texture));
    }
    first->make_current();
    EXPECT_TRUE(glIsTexture(texture));
    glDeleteTextures(1, &texture);
}

/// Mesa pretends to be old, for the whole process: this runs in one of its own.
[[noreturn]] void say_what_an_old_driver_gets() {
    setenv("MESA_GL_VERSION_OVERRIDE", "3.3", 1);
    setenv("LIBGL_ALWAYS_SOFTWARE", "1", 1);
    try {
        (void)create_headless_context();
    } catch (const Error& error) {
        std::fputs(error.what(), stderr);
        _exit(3);
    }
    _exit(0);
}

TEST(HeadlessDeathTest, AnOldDriverIsOneClearMessage) {
    testing::FLAGS_gtest_death_test_style = "threadsafe";
    EXPECT_EXIT(say_what_an_old_driver_gets(), testing::ExitedWithCode(3),
                "this driver gives OpenGL 3.3 .*expected OpenGL 4.5 core");
}

/// A window where there is a display; elsewhere the test is skipped.
class Windowed : public testing::Test {
 protected:
    void SetUp() override {
        if (!std::getenv("DISPLAY") && !std::getenv("WAYLAND_DISPLAY")) GTEST_SKIP() << "there is no display";
        window_ = std::make_unique<Window>(
            WindowDesc{.title = "test", .size = {320, 200}, .vsync = false, .context = {.debug = true}});
        settle();
    }
    void TearDown() override {
        if (!window_) return;
        for (const std::string& message : window_->take_debug_messages()) ADD_FAILURE() << message;
    }
    /// The window system answers when it likes.
    void settle() {
        for (int i = 0; i < 20; ++i) {
            window_->poll();
            usleep(5000);
        }
    }
    /// A pixel of the window's back buffer, from the bottom left.
    static glm::ivec4 pixel(int x, int y) {
        std::array<unsigned char, 4> p{};
        glReadBuffer(GL_BACK);
        glReadPixels(x, y, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, p.data());
        return {p[0], p[1], p[2], p[3]};
    }
    std::unique_ptr<Window> window_;
};

TEST_F(Windowed, ShowsATextureWithItsProportions) {
#ifdef __SANITIZE_ADDRESS__
    GTEST_SKIP() << "Mesa 22.3 never frees the two surfaces (112 bytes) of a window that anything was blitted to";
#endif
    gpu::Texture picture({gpu::Shape::flat, gpu::Format::rgba8, 2, 2}, "picture");
    const std::array<unsigned char, 16> texels{255, 0, 0, 255, 255, 0, 0, 255, 0, 0, 255, 255, 0, 0, 255, 255};
    picture.upload(0, 0, texels.data());
    const glm::ivec2 size = window_->framebuffer_size();
    ASSERT_GT(size.x, size.y);
    window_->blit(picture.name(), {2, 2});
    EXPECT_EQ(glm::ivec3(pixel(size.x / 2, 2)), glm::ivec3(255, 0, 0)) << "the first row is the lowest";
    EXPECT_EQ(glm::ivec3(pixel(size.x / 2, size.y - 3)), glm::ivec3(0, 0, 255));
    EXPECT_EQ(glm::ivec3(pixel(1, size.y / 2)), glm::ivec3(0)) << "bars at the sides";
    window_->swap();
}

TEST_F(Windowed, ResizesAndFillsTheScreenAndComesBack) {
    window_->resize({400, 300});
    settle();
    EXPECT_EQ(window_->size(), glm::ivec2(400, 300));
    window_->set_fullscreen(true);
    settle();
    EXPECT_TRUE(window_->fullscreen());
    EXPECT_GT(window_->size().x, 400);
    window_->set_fullscreen(false);
    settle();
    EXPECT_FALSE(window_->fullscreen());
    EXPECT_EQ(window_->size(), glm::ivec2(400, 300));
    EXPECT_GT(window_->framebuffer_size().x, 0);
    EXPECT_GT(window_->content_scale(), 0.0f);
}

TEST_F(Windowed, ClosesAndCapturesWhenAsked) {
    EXPECT_FALSE(window_->close_requested());
    window_->request_close();
    EXPECT_TRUE(window_->close_requested());
    window_->capture_mouse(true);
    EXPECT_TRUE(window_->mouse_captured());
    window_->capture_mouse(false);
    EXPECT_FALSE(window_->mouse_captured());
}

TEST(WindowDeathTest, WithoutADisplayTheMessageSaysSo) {
    testing::FLAGS_gtest_death_test_style = "threadsafe";
    const auto open = [] {
        unsetenv("DISPLAY");
        unsetenv("WAYLAND_DISPLAY");
        try {
            const Window window({});
        } catch (const Error& error) {
            std::fputs(error.what(), stderr);
            _exit(3);
        }
        _exit(0);
    };
    EXPECT_EXIT(open(), testing::ExitedWithCode(3), "a window cannot be opened: .*expected a running display");
}

}  // namespace
}  // namespace tyndall::platform
