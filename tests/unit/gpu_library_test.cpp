#include <gtest/gtest.h>

#include <array>

#include "core/error.h"
#include "core/log.h"
#include "core/paths.h"
#include "gpu/shader_library.h"
#include "gpu/shader_source.h"
#include "gpu_fixture.h"

namespace tyndall::gpu {
namespace {
namespace fs = std::filesystem;

using GpuLibrary = GpuTest;

/// The red of a 1x1 target after a full-screen draw.
float red(const Program& program) {
    Texture target({Shape::flat, Format::rgba32f}, "target");
    const std::array<Framebuffer::Attachment, 1> colours{{{&target}}};
    const Framebuffer framebuffer(colours, {}, "target");
    framebuffer.bind();
    program.use();
    draw_fullscreen();
    return target.read()[0].x;
}

std::string error_of(ShaderLibrary& library, const ProgramDesc& desc) {
    try {
        (void)library.program(desc);
    } catch (const Error& error) {
        return error.what();
    }
    return {};
}

constexpr const char* kMain = "out vec4 colour;\nvoid main() { colour = vec4(value()); }\n";
const ProgramDesc kDesc{.name = "changing", .fragment = "fog/main.frag"};

TEST_F(GpuLibrary, DriversMessagesPointIntoTheRightFile) {
    TemporaryFolder folder;
    folder.write("deep.glsl", "float fine() { return 1.0; }\n\nfloat deep() { return no_such_name; }\n");
    folder.write("main.frag",
                 "#include \"fog/deep.glsl\"\nout vec4 colour;\nvoid main() {\n    colour = vec4(missing);\n}\n");
    ShaderLibrary library;
    library.add_folder("fog", folder.path());
    const std::string message = error_of(library, kDesc);
    EXPECT_NE(message.find((folder.path() / "deep.glsl").string() + ":3:"), std::string::npos) << message;
    EXPECT_NE(message.find((folder.path() / "main.frag").string() + ":4:"), std::string::npos) << message;
    EXPECT_NE(message.find("no_such_name"), std::string::npos) << message;
    EXPECT_NE(message.find("building program 'changing'"), std::string::npos) << message;
    EXPECT_EQ(library.broken(), message);
}

TEST_F(GpuLibrary, MissingIncludesNameTheNearest) {
    TemporaryFolder folder;
    folder.write("noise.glsl", "float noise() { return 0.5; }\n");
    folder.write("main.frag", "out vec4 colour;\n#include \"fog/nois.glsl\"\nvoid main() {}\n");
    ShaderLibrary library;
    library.add_folder("fog", folder.path());
    const std::string message = error_of(library, kDesc);
    EXPECT_NE(message.find("main.frag:2:"), std::string::npos) << message;
    EXPECT_NE(message.find("did you mean 'fog/noise.glsl'"), std::string::npos) << message;
    folder.write("main.frag", "#include fog/noise.glsl\nvoid main() {}\n");
    library.reload_changed();
    EXPECT_NE(error_of(library, kDesc).find("main.frag:1: #include without a quoted name"), std::string::npos)
        << error_of(library, kDesc);
    folder.write("main.frag", "#include \"../secret.glsl\"\nvoid main() {}\n");
    library.reload_changed();
    EXPECT_NE(error_of(library, kDesc).find("no shader text '../secret.glsl'"), std::string::npos);
    EXPECT_NE(error_of(library, {.name = "x", .fragment = "fog/../../x.frag"}), "");
}

TEST_F(GpuLibrary, IncludesComeOnceAndCirclesEnd) {
    ShaderLibrary library;
    library.set_text("a.glsl", "#include \"b.glsl\"\nfloat a() { return b0; }\n");
    library.set_text("b.glsl", "#include \"a.glsl\"\nconst float b0 = 2.0;\n");
    library.set_text(
        "c.frag",
        "#include \"a.glsl\"\n  #  include \"b.glsl\"\nout vec4 colour;\nvoid main() { colour = vec4(a()); }\n");
    EXPECT_EQ(red(library.program({.name = "circle", .fragment = "c.frag"})), 2.0f);
}

TEST_F(GpuLibrary, DefinesMakeVariants) {
    ShaderLibrary library;
    library.set_text("v.frag", R"(
FN void twice(INOUT(float) x, OUT(float) y) { x *= 2.0; y = x; }
out vec4 colour;
void main() {
    float x = VALUE, y;
    twice(x, y);
#ifdef PLUS_ONE
    y += 1.0;
#endif
    colour = vec4(y);
})");
    const Program& a = library.program({.name = "v", .fragment = "v.frag", .defines = {"VALUE 3.0"}});
    const Program& b = library.program({.name = "v", .fragment = "v.frag", .defines = {"VALUE 4.0", "PLUS_ONE"}});
    EXPECT_EQ(red(a), 6.0f);
    EXPECT_EQ(red(b), 9.0f);
    EXPECT_EQ(&a, &library.program({.name = "v", .fragment = "v.frag", .defines = {"VALUE 3.0"}}));
}

TEST_F(GpuLibrary, AChangedFileIsReloadedAndABrokenOneKeepsTheLastGood) {
    TemporaryFolder folder;
    folder.write("value.glsl", "float value() { return 1.0; }\n");
    folder.write("main.frag", std::string("#include \"fog/value.glsl\"\n") + kMain);
    ShaderLibrary library;
    library.add_folder("fog", folder.path());
    const Program& program = library.program(kDesc);
    EXPECT_EQ(red(program), 1.0f);
    EXPECT_EQ(library.reload_changed(), 0);

    folder.write("value.glsl", "float value() { return 2.0; }\n");
    EXPECT_EQ(library.reload_changed(), 1);
    EXPECT_EQ(red(program), 2.0f);

    folder.write("value.glsl", "float value() { return oops; }\n");
    std::string logged;
    log::set_sink([&](log::Level, std::string_view text) { logged += text; });
    EXPECT_EQ(library.reload_changed(), 0);
    log::set_sink({});
    EXPECT_NE(logged.find("value.glsl:1:"), std::string::npos) << logged;
    EXPECT_NE(library.broken().find("oops"), std::string::npos) << library.broken();
    EXPECT_EQ(red(program), 2.0f);
    EXPECT_EQ(&library.program(kDesc), &program);

    fs::remove(folder.path() / "value.glsl");
    EXPECT_EQ(library.reload_changed(), 0);
    EXPECT_EQ(red(library.program(kDesc)), 2.0f);
    EXPECT_NE(library.broken().find("no shader text 'fog/value.glsl'"), std::string::npos) << library.broken();

    folder.write("value.glsl", "float value() { return 3.0; }\n");
    EXPECT_EQ(library.reload_changed(), 1);
    EXPECT_EQ(red(program), 3.0f);
    EXPECT_EQ(library.broken(), "");
}

TEST_F(GpuLibrary, GeneratedTextsRebuildTheirReadersOnly) {
    ShaderLibrary library;
    library.set_text("seam.glsl", "float value() { return 1.0; }\n");
    library.set_text("reader.frag", std::string("#include \"seam.glsl\"\n") + kMain);
    library.set_text("other.frag", "out vec4 colour;\nvoid main() { colour = vec4(7.0); }\n");
    const Program& reader = library.program({.name = "reader", .fragment = "reader.frag"});
    const Program& other = library.program({.name = "other", .fragment = "other.frag"});
    const unsigned int other_name = other.name();
    const unsigned int reader_name = reader.name();
    library.set_text("seam.glsl", "float value() { return 1.0; }\n");  // the same: nothing to do
    EXPECT_EQ(library.program({.name = "reader", .fragment = "reader.frag"}).name(), reader_name);
    library.set_text("seam.glsl", "float value() { return 5.0; }\n");
    EXPECT_EQ(&library.program({.name = "reader", .fragment = "reader.frag"}), &reader);
    EXPECT_EQ(red(reader), 5.0f);
    EXPECT_EQ(library.program({.name = "other", .fragment = "other.frag"}).name(), other_name);
}

TEST_F(GpuLibrary, AGeneratedTextShadowsAFile) {
    TemporaryFolder folder;
    folder.write("value.glsl", "float value() { return 1.0; }\n");
    folder.write("main.frag", std::string("#include \"fog/value.glsl\"\n") + kMain);
    ShaderLibrary library;
    library.add_folder("fog", folder.path());
    EXPECT_EQ(red(library.program(kDesc)), 1.0f);
    library.set_text("fog/value.glsl", "float value() { return 4.0; }\n");
    EXPECT_EQ(red(library.program(kDesc)), 4.0f);
}

TEST_F(GpuLibrary, DroppedProgramsGiveBackTheirObjects) {
    ShaderLibrary library;
    library.set_text("x.frag", "out vec4 colour;\nvoid main() { colour = vec4(1.0); }\n");
    const int start = alive().programs;
    (void)library.program({.name = "fog/a", .fragment = "x.frag"});
    (void)library.program({.name = "fog/b", .fragment = "x.frag"});
    (void)library.program({.name = "sky", .fragment = "x.frag"});
    EXPECT_EQ(alive().programs, start + 3);
    library.drop("fog/");
    EXPECT_EQ(alive().programs, start + 1);
}

TEST_F(GpuLibrary, StagesThatDoNotMatchAreALinkError) {
    ShaderLibrary library;
    library.set_text("x.frag",
                     "in vec3 not_given;\nout vec4 colour;\nvoid main() { colour = vec4(not_given, 1.0); }\n");
    EXPECT_NE(error_of(library, {.name = "unlinked", .fragment = "x.frag"}).find("linking program 'unlinked'"),
              std::string::npos);
}

TEST_F(GpuLibrary, EveryPhysicsTextIsGlslAlone) {
    const fs::path folder = paths::root() / "engine" / "physics";
    ShaderLibrary library;
    int texts = 0;
    for (const auto& entry : fs::directory_iterator(folder)) {
        if (entry.path().extension() != ".glsl") continue;
        const std::string name = "physics/" + entry.path().filename().string();
        library.set_text("test.comp", "layout(local_size_x = 1) in;\n#include \"" + name + "\"\nvoid main() {}\n");
        EXPECT_EQ(error_of(library, {.name = name, .compute = "test.comp"}), "");
        ++texts;
    }
    EXPECT_GT(texts, 0) << folder;
}

TEST(ShaderLog, TheFormsOfThreeDriversAreUnderstood) {
    const StageText stage{"", {"front", "a.frag", "b.glsl"}, {{0, 1}, {1, 1}, {2, 1}, {2, 2}, {1, 3}}};
    const auto read = [&](const char* log) { return translate_log(log, stage); };
    const auto mesa = read("0:4(5): error: `x' undeclared\n0:3(1): warning: unused\n");
    ASSERT_EQ(mesa.size(), 1u);
    EXPECT_EQ(mesa[0].text(), "b.glsl:2:5: error: `x' undeclared");
    const auto nvidia = read("0(5) : error C1503: undefined variable \"x\"\n");
    EXPECT_EQ(nvidia.at(0).where.file, "a.frag");
    EXPECT_EQ(nvidia.at(0).where.line, 3);
    const auto amd = read("ERROR: 0:3: 'x' : undeclared identifier\n");
    EXPECT_EQ(amd.at(0).where.file, "b.glsl");
    EXPECT_EQ(amd.at(0).where.line, 1);
    EXPECT_EQ(read("0:9(1): error: x").at(0).where.file, "");
    EXPECT_EQ(read("something else").at(0).message, "something else");
}

}  // namespace
}  // namespace tyndall::gpu
