#pragma once
// A folder of modules whose builds a test exchanges, and what modules are loaded into.

#include <fstream>

#include "core/paths.h"
#include "ecs/world.h"
#include "gpu_fixture.h"
#include "module/module_manager.h"

namespace tyndall {

inline std::filesystem::path test_modules() {
    return paths::build() / "test_modules";
}

/// Rooms for modules without a renderer.
struct ModuleStage {
    ComponentRegistry registry;
    Extractors extractors;
    Settings settings;
    World world{registry};
    ModuleHost host(Renderer* renderer = nullptr) { return {registry, extractors, settings, {&world}, renderer}; }
};

/// Puts a build of a module in place as the build tool does: written beside and renamed, with a new time.
inline void put_module(const std::filesystem::path& folder, const std::string& generation, const std::string& name) {
    const std::filesystem::path next = folder / (name + ".next");
    std::filesystem::copy_file(test_modules() / generation / (name + ".so"), next,
                               std::filesystem::copy_options::overwrite_existing);
    std::filesystem::rename(next, folder / (name + ".so"));
}

/// How many mappings of this process come from copies of a module's library.
inline int mappings_of(const std::string& name) {
    std::ifstream maps("/proc/self/maps");
    int found = 0;
    for (std::string line; std::getline(maps, line);)
        if (line.find("_" + name + ".so") != std::string::npos) ++found;
    return found;
}

/// Resident memory of this process in KiB.
inline long resident_kib() {
    std::ifstream status("/proc/self/status");
    for (std::string word; status >> word;)
        if (word == "VmRSS:") {
            long kib = 0;
            status >> kib;
            return kib;
        }
    return 0;
}

}  // namespace tyndall
