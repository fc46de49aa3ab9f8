#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "core/error.h"
#include "core/paths.h"

namespace tyndall {
namespace fs = std::filesystem;
namespace {

class TemporaryFolder : public testing::Test {
 protected:
    void SetUp() override {
        folder_ = fs::temp_directory_path() / ("tyndall_core_" + std::to_string(getpid()));
        fs::create_directories(folder_ / "inside");
        std::ofstream(folder_ / "inside" / "stone.png") << "x";
        std::ofstream(folder_ / "secret.txt") << "x";
    }
    void TearDown() override { fs::remove_all(folder_); }
    fs::path folder_;
};

TEST(Error, SaysWhereWhatExpectedAndNearest) {
    const Diagnostic d{{"a.json", 12, 7, "/entities/3"}, "unknown component 'medum'", "a component name", "medium"};
    EXPECT_EQ(
        d.text(),
        "a.json:12:7: /entities/3: unknown component 'medum' (expected a component name; did you mean 'medium'?)");
    Error error(d);
    error.within("loading scene");
    EXPECT_EQ(std::string(error.what()), "loading scene: " + d.text());
}

TEST(NearestName, IsNearOrEmpty) {
    const std::vector<std::string> names{"medium", "spot_light", "point_light"};
    EXPECT_EQ(nearest_name("medum", names), "medium");
    EXPECT_EQ(nearest_name("spotlight", names), "spot_light");
    EXPECT_EQ(nearest_name("banana", names), "");
}

TEST_F(TemporaryFolder, AssetNamesStayInside) {
    EXPECT_EQ(paths::resolve_asset(folder_ / "inside", "stone.png"), fs::canonical(folder_ / "inside" / "stone.png"));
    EXPECT_THROW((void)paths::resolve_asset(folder_ / "inside", "../secret.txt"), Error);
    EXPECT_THROW((void)paths::resolve_asset(folder_ / "inside", (folder_ / "secret.txt").string()), Error);
    fs::create_symlink(folder_ / "secret.txt", folder_ / "inside" / "link.png");
    EXPECT_THROW((void)paths::resolve_asset(folder_ / "inside", "link.png"), Error);
    try {
        (void)paths::resolve_asset(folder_ / "inside", "ston.png");
        FAIL();
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find("stone.png"), std::string::npos) << error.what();
    }
}

TEST_F(TemporaryFolder, AtomicWriteReplaces) {
    paths::write_file_atomically(folder_ / "f", "one");
    paths::write_file_atomically(folder_ / "f", "two");
    EXPECT_EQ(paths::read_file(folder_ / "f"), "two");
    EXPECT_THROW(paths::write_file_atomically(folder_ / "no" / "f", "x"), Error);
    EXPECT_EQ(std::distance(fs::directory_iterator(folder_), {}), 3);  // no temporary is left
}

}  // namespace
}  // namespace tyndall
