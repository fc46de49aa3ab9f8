// Noticing saved files, with the time given by the test.
#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>

#include "core/file_watch.h"

namespace tyndall {
namespace fs = std::filesystem;
namespace {

using Paths = std::vector<fs::path>;

class FileWatching : public testing::Test {
 protected:
    void SetUp() override {
        folder_ = fs::temp_directory_path() / ("tyndall_watch_" + std::to_string(getpid()));
        fs::create_directories(folder_ / "shaders" / "deep");
        file_ = folder_ / "scene.json";
        write(file_, "one");
    }
    void TearDown() override { fs::remove_all(folder_); }
    static void write(const fs::path& file, const std::string& text) { std::ofstream(file) << text; }
    /// One look, an interval after the last.
    Paths look() { return watch_.changed(now_ += std::chrono::milliseconds(100)); }

    fs::path folder_, file_;
    FileWatch watch_;
    FileWatch::Clock::time_point now_;
};

TEST_F(FileWatching, AChangeIsReportedOnceItHasSettled) {
    watch_.add(file_);
    EXPECT_EQ(look(), Paths{});
    write(file_, "three");
    EXPECT_EQ(look(), Paths{});
    EXPECT_EQ(watch_.changed(now_ + std::chrono::milliseconds(50)), Paths{});  // too early to look again
    EXPECT_EQ(look(), Paths{file_});
    EXPECT_EQ(look(), Paths{});
}

TEST_F(FileWatching, WritingInTwoStepsIsOneChange) {
    watch_.add(file_);
    write(file_, "");
    EXPECT_EQ(look(), Paths{});
    write(file_, "half");
    EXPECT_EQ(look(), Paths{});
    write(file_, "all of it");
    EXPECT_EQ(look(), Paths{});
    EXPECT_EQ(look(), Paths{file_});
    EXPECT_EQ(look(), Paths{});
}

TEST_F(FileWatching, RenamingOverIsAChangeEvenWithTheSameTimeAndSize) {
    watch_.add(file_);
    const auto time = fs::last_write_time(file_);
    write(folder_ / "scene.json.tmp", "two");
    fs::last_write_time(folder_ / "scene.json.tmp", time);
    fs::rename(folder_ / "scene.json.tmp", file_);
    look();
    EXPECT_EQ(look(), Paths{file_});
}

TEST_F(FileWatching, WhatVanishesIsReportedWhenItIsBack) {
    const fs::path later = folder_ / "later.json";
    watch_.add(file_);
    watch_.add(later);
    fs::rename(file_, folder_ / "away");
    EXPECT_EQ(look(), Paths{});
    EXPECT_EQ(look(), Paths{});
    fs::rename(folder_ / "away", file_);
    write(later, "new");
    look();
    EXPECT_EQ(look(), (Paths{later, file_}));
    EXPECT_EQ(look(), Paths{});
    watch_.remove(file_);
    write(file_, "unwatched now");
    look();
    EXPECT_EQ(look(), Paths{});
}

TEST_F(FileWatching, FoldersReportWhatIsInsideAndComesInside) {
    const fs::path old = folder_ / "shaders" / "deep" / "old.glsl", made = folder_ / "shaders" / "made.glsl";
    write(old, "x");
    watch_.add(folder_ / "shaders");
    watch_.add(folder_ / "shaders");  // twice changes nothing
    look();
    EXPECT_EQ(look(), Paths{});
    write(old, "changed");
    write(made, "y");
    write(folder_ / "shaders" / ".made.glsl.swp", "an editor's own");
    write(folder_ / "shaders" / "made.glsl~", "an editor's own");
    look();
    EXPECT_EQ(look(), (Paths{old, made}));
    fs::remove(made);
    look();
    EXPECT_EQ(look(), Paths{});
    write(made, "back");
    look();
    EXPECT_EQ(look(), Paths{made});
    fs::remove_all(folder_ / "shaders");
    look();
    EXPECT_EQ(look(), Paths{});
    fs::create_directories(folder_ / "shaders");
    write(made, "again");
    look();
    EXPECT_EQ(look(), Paths{made});
}

TEST_F(FileWatching, FoldersInALoopDoNotHangIt) {
    fs::create_directory_symlink(folder_, folder_ / "shaders" / "loop");
    watch_.add(folder_);
    look();
    write(file_, "changed");
    look();
    EXPECT_EQ(look(), Paths{file_});
}

}  // namespace
}  // namespace tyndall
