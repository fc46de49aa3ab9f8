#pragma once
/// Loads, reloads and unloads modules by name, from the module folder only.

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/file_watch.h"
#include "module/kept_state.h"
#include "module/library.h"
#include "module/registration.h"

namespace tyndall {

enum class ModuleState {
    available,  ///< there, not loaded
    not_found,
    wrong_interface,  ///< not a module, or built against another engine
    unresolved_dependency,
    failed,  ///< its constructor or install threw
    loaded,
    outdated,  ///< loaded, but a newer build could not take over: `problem` says why
};
[[nodiscard]] std::string_view name_of(ModuleState state);

/// What `tyndall modules` shows.
struct ModuleReport {
    std::string name;
    ModuleState state = ModuleState::available;
    std::string version, summary, problem;
    std::vector<std::string> depends, components, settings, passes, seams;
};

/// The modules of a program. A module that cannot be loaded is reported and left out; the program goes on.
class ModuleManager {
 public:
    /// `folder` holds NAME.so; `sources` holds NAME/shaders. The host must outlive the manager.
    ModuleManager(ModuleHost host, std::filesystem::path folder, std::filesystem::path sources);
    ~ModuleManager();

    /// Loads a module and what it depends on. Returns false, and logs and keeps the reason, when that fails.
    bool load(const std::string& name);
    /// Loads the newest build of a loaded module in its place, with all that users authored. Returns false when the new
    /// one is broken: then the old one runs on and its report says why.
    bool reload(const std::string& name);
    /// Unloads it and those that depend on it; their components are kept for a later load. One that is broken is no
    /// longer asked for, and its problem forgotten.
    void unload(const std::string& name);
    /// Reloads the modules whose file changed since they were loaded, and tries those again that were asked for and
    /// could not be loaded. Returns the names of those that were.
    std::vector<std::string> reload_changed();
    [[nodiscard]] bool loaded(std::string_view name) const;

    /// The loaded ones, in the order of their first loading.
    [[nodiscard]] const std::vector<std::string>& in_use() const { return order_; }
    /// All modules: those in the folder and those asked for.
    [[nodiscard]] std::vector<ModuleReport> reports() const;
    /// Names of the module folder.
    [[nodiscard]] std::vector<std::string> available() const;

 private:
    struct Entry {
        std::unique_ptr<ModuleLibrary> library;  // outlives what it registered
        std::unique_ptr<Registration> registration;
        KeptState kept;
        ModuleState state = ModuleState::available;
        std::string problem;
    };
    [[nodiscard]] std::filesystem::path file(const std::string& name) const;
    void check_name(const std::string& name) const;
    void check_dependencies(const ModuleLibrary& library);
    [[nodiscard]] std::unique_ptr<Registration> install(ModuleLibrary& library);
    void go_back(const std::string& name, const Error& why);
    [[nodiscard]] bool wanted(const std::string& name) const;
    [[nodiscard]] std::vector<std::string> dependencies(const std::string& name) const;
    [[nodiscard]] bool leads_to(const std::string& name, const std::string& other) const;
    bool fail(const std::string& name, ModuleState state, const std::exception& error);

    ModuleHost host_;
    std::filesystem::path folder_, sources_;
    std::map<std::string, Entry> modules_;
    std::vector<std::string> order_;
    FileWatch watch_;
    std::vector<std::string> loading_;  // guards against circles
};

}  // namespace tyndall
