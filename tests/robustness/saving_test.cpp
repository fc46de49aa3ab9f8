// A program that is killed while it saves leaves the old file or the new one, whole.

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <random>
#include <string>

#include "core/paths.h"

namespace tyndall {
namespace {

namespace fs = std::filesystem;

constexpr int kRounds = 200;
constexpr size_t kSize = 200'000;  // several writes of the disk's blocks

/// The folder of one test, removed with it.
struct Folder {
    fs::path path;
    Folder() {
        std::string name = (fs::temp_directory_path() / "tyndall_saving_XXXXXX").string();
        path = mkdtemp(name.data());
    }
    ~Folder() { fs::remove_all(path); }
};

/// All of one letter, so that a mixture shows.
std::string content(int round) {
    return std::string(kSize + static_cast<size_t>(round % 7), static_cast<char>('a' + round % 26));
}

TEST(Saving, KilledAtAnyTimeLeavesAWholeFile) {
    const Folder folder;
    const fs::path file = folder.path / "scene.json";
    paths::write_file_atomically(file, content(0));
    std::mt19937 dice(1);
    int replaced = 0, kept = 0;
    for (int round = 1; round <= kRounds; ++round) {
        const std::string before = paths::read_file(file), after = content(round);
        const pid_t child = fork();
        ASSERT_GE(child, 0);
        if (child == 0) {
            paths::write_file_atomically(file, after);
            _exit(0);
        }
        usleep(std::uniform_int_distribution<useconds_t>(0, 3000)(dice));
        kill(child, SIGKILL);
        int status = 0;
        ASSERT_EQ(waitpid(child, &status, 0), child);
        const std::string now = paths::read_file(file);
        ASSERT_TRUE(now == before || now == after) << "round " << round << ": " << now.size() << " bytes";
        ++(now == after ? replaced : kept);
    }
    RecordProperty("replaced", replaced);
    RecordProperty("kept", kept);
    paths::write_file_atomically(file, "the end");  // temporaries left by the dead are in nobody's way
    EXPECT_EQ(paths::read_file(file), "the end");
}

}  // namespace
}  // namespace tyndall
