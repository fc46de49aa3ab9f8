#pragma once
/// Rebuilds modules in the background when their sources are saved.

#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>

#include "core/file_watch.h"
#include "core/process.h"

namespace tyndall {

/// Watches the folders of modules/ and runs the build for those that changed, one at a time, without holding the frame
/// up. The rebuilt library is noticed by ModuleManager::reload_changed.
class ModuleBuilder {
 public:
    /// `build` is a configured build folder; `sources` holds one folder per module.
    ModuleBuilder(std::filesystem::path build, std::filesystem::path sources);
    ~ModuleBuilder();
    ModuleBuilder(const ModuleBuilder&) = delete;
    ModuleBuilder& operator=(const ModuleBuilder&) = delete;

    /// Starts builds that are due and takes the results of finished ones. Cheap; call it every frame.
    void update();
    [[nodiscard]] bool building() const { return process_.has_value(); }
    /// What the compiler said of modules whose last build failed; empty when all is well.
    [[nodiscard]] std::string problems() const;

 private:
    void start(const std::string& module);
    void finish();

    std::filesystem::path build_, sources_, log_;
    FileWatch watch_;
    std::set<std::string> due_;  ///< modules whose sources were saved
    std::map<std::string, std::string> problems_;
    std::string module_;  ///< under way
    std::optional<Process> process_;
};

}  // namespace tyndall
