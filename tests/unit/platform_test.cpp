#include <epoxy/gl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>

#include "core/error.h"
#include "platform/context.h"

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

}  // namespace
}  // namespace tyndall::platform
