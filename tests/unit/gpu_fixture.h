#pragma once
/// A headless context for every test that draws: driver messages and leaked objects fail the test.

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <memory>
#include <string>

#include "gpu/gpu.h"
#include "platform/context.h"

namespace tyndall {

class GpuTest : public testing::Test {
 protected:
    static void SetUpTestSuite() { context_ = platform::create_headless_context({.debug = true}); }
    static void TearDownTestSuite() { context_.reset(); }
    void SetUp() override {
        context_->make_current();
        before_ = gpu::alive();
    }
    void TearDown() override {
        gpu::release_samplers();
        for (const std::string& message : context_->take_debug_messages()) ADD_FAILURE() << message;
        EXPECT_EQ(gpu::alive(), before_) << "GL objects leaked";
    }

    static inline std::unique_ptr<platform::Context> context_;
    gpu::Alive before_;
};

/// A folder of its own for a test, gone afterwards.
class TemporaryFolder {
 public:
    TemporaryFolder() {
        std::string name = (std::filesystem::temp_directory_path() / "tyndall_test_XXXXXX").string();
        path_ = mkdtemp(name.data());
    }
    ~TemporaryFolder() { std::filesystem::remove_all(path_); }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;
    [[nodiscard]] const std::filesystem::path& path() const { return path_; }
    /// Writes a file with a time stamp later than any before, however coarse the file system's clock.
    void write(const std::string& name, const std::string& text) {
        std::filesystem::create_directories((path_ / name).parent_path());
        std::ofstream(path_ / name) << text;
        std::filesystem::last_write_time(
            path_ / name, std::filesystem::file_time_type::clock::now() + std::chrono::seconds(++ticks_));
    }

 private:
    std::filesystem::path path_;
    int ticks_ = 0;
};

}  // namespace tyndall
