// The same files as GLSL: each one alone through the reference compiler, with what the shader library puts in front.

#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "physics_test.h"

namespace tyndall::physics {
namespace {

namespace fs = std::filesystem;

TEST(Glsl, EveryFileCompilesAlone) {
    if (std::system("command -v glslangValidator > /dev/null") != 0)
        GTEST_SKIP() << "glslangValidator is not installed";
    const fs::path folder = fs::temp_directory_path() / ("tyndall_physics_" + std::to_string(getpid()));
    fs::create_directories(folder);
    int files = 0;
    for (const fs::directory_entry& entry : fs::directory_iterator("engine/physics")) {
        if (entry.path().extension() != ".glsl") continue;
        const fs::path shader = folder / "shader.comp";
        std::ofstream(shader) << "#version 450 core\n#extension GL_GOOGLE_include_directive : require\n"
                              << "#define FN\n#define OUT(T) out T\n#define INOUT(T) inout T\n"
                              << "#include \"physics/" << entry.path().filename().string() << "\"\n"
                              << "layout(local_size_x = 1) in;\nvoid main() {}\n";
        const std::string command = "glslangValidator -G -o /dev/null -I" + fs::absolute("engine").string() + " " +
                                    shader.string() + " > " + (folder / "log").string();
        if (std::system(command.c_str()) != 0) {
            std::ifstream log(folder / "log");
            ADD_FAILURE() << entry.path() << ": " << std::string((std::istreambuf_iterator<char>(log)), {});
        }
        ++files;
    }
    fs::remove_all(folder);
    EXPECT_GE(files, 15);
}

/// C++ compiles physics.h only: whatever lies in the folder must be in it.
TEST(Glsl, AllIncludesEveryFile) {
    std::ifstream stream("engine/physics/all.glsl");
    const std::string text((std::istreambuf_iterator<char>(stream)), {});
    for (const fs::directory_entry& entry : fs::directory_iterator("engine/physics")) {
        const std::string name = entry.path().filename().string();
        if (entry.path().extension() != ".glsl" || name == "all.glsl") continue;
        EXPECT_NE(text.find("\"physics/" + name + "\""), std::string::npos) << name;
    }
}

}  // namespace
}  // namespace tyndall::physics
