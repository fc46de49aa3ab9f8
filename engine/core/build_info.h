#pragma once
/// What this build is: for `tyndall info`, and written beside captures.

#include <string>

namespace tyndall {

/// Facts of the build.
struct BuildInfo {
    std::string version;   ///< of the project, "0.1.0"
    std::string revision;  ///< git's name for the commit, or "unknown" outside a repository
    std::string compiler;  ///< "GNU 12.2.0"
    std::string preset;    ///< of CMake: "release", "debug", "asan", "tsan"; else the build type
};

/// The facts of this build.
[[nodiscard]] const BuildInfo& build_info();

}  // namespace tyndall
