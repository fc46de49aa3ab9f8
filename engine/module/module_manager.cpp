#include "module/module_manager.h"

#include <algorithm>
#include <sstream>
#include <utility>

#include "core/log.h"
#include "render/renderer.h"

namespace tyndall {
namespace fs = std::filesystem;
namespace {

std::vector<std::string> split(std::string_view list) {
    std::vector<std::string> parts;
    std::istringstream in{std::string(list)};
    for (std::string part; std::getline(in, part, ',');) {
        part.erase(0, part.find_first_not_of(' '));
        part.erase(part.find_last_not_of(' ') + 1);
        if (!part.empty()) parts.push_back(part);
    }
    return parts;
}

bool contains(const std::vector<std::string>& names, const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

/// A module is being loaded as long as this lives.
class Loading {
 public:
    Loading(std::vector<std::string>& list, const std::string& name) : list_(list) { list_.push_back(name); }
    ~Loading() { list_.pop_back(); }
    Loading(const Loading&) = delete;
    Loading& operator=(const Loading&) = delete;

 private:
    std::vector<std::string>& list_;
};

}  // namespace

const char* abi_tag() {
    return TYNDALL_ABI_TAG;
}

std::string_view name_of(ModuleState state) {
    switch (state) {
        case ModuleState::available:
            return "available";
        case ModuleState::not_found:
            return "not found";
        case ModuleState::wrong_interface:
            return "wrong interface";
        case ModuleState::unresolved_dependency:
            return "unresolved dependency";
        case ModuleState::failed:
            return "failed";
        case ModuleState::loaded:
            return "loaded";
        case ModuleState::outdated:
            return "outdated";
    }
    return "";
}

ModuleManager::ModuleManager(ModuleHost host, fs::path folder, fs::path sources)
    : host_(std::move(host)), folder_(std::move(folder)), sources_(std::move(sources)) {
    watch_.add(folder_);
}

ModuleManager::~ModuleManager() {
    while (!order_.empty()) unload(order_.back());
}

bool ModuleManager::load(const std::string& name) {
    if (loaded(name)) return true;
    ModuleState state = ModuleState::not_found;
    const Loading guard(loading_, name);
    try {
        check_name(name);
        state = ModuleState::wrong_interface;
        auto library = std::make_unique<ModuleLibrary>(file(name), name);
        state = ModuleState::unresolved_dependency;
        check_dependencies(*library);
        state = ModuleState::failed;
        library->create();
        auto registration = install(*library);
        Entry& entry = modules_[name];
        entry.library = std::move(library);
        entry.registration = std::move(registration);
        entry.state = ModuleState::loaded;
        entry.problem.clear();
        order_.push_back(name);
        entry.kept.restore(host_, *entry.registration);
        return true;
    } catch (const std::exception& error) {
        return fail(name, state, error);
    }
}

bool ModuleManager::reload(const std::string& name) {
    if (!loaded(name)) return load(name);
    Entry& entry = modules_[name];
    const Loading guard(loading_, name);
    try {
        auto next = std::make_unique<ModuleLibrary>(file(name), name);
        check_dependencies(*next);
        next->create();
        entry.kept.save(host_, *entry.registration);
        entry.registration.reset();
        try {
            entry.registration = install(*next);
            std::swap(entry.library, next);
        } catch (const Error& error) {
            go_back(name, error);
            throw;
        }
        entry.kept.restore(host_, *entry.registration);
        entry.state = ModuleState::loaded;
        entry.problem.clear();
        log::info("module {} reloaded", name);
        return true;
    } catch (const std::exception& error) {
        return fail(name, loaded(name) ? ModuleState::outdated : ModuleState::failed, error);
    }
}

/// Installs the library that was in use again; when even that fails now, the module is unloaded.
void ModuleManager::go_back(const std::string& name, const Error& why) {
    Entry& entry = modules_[name];
    try {
        entry.registration = install(*entry.library);
        entry.kept.restore(host_, *entry.registration);
    } catch (const Error& error) {
        unload(name);
        throw Error(std::string(why.what()) + "; the build before it does not install again: " + error.what());
    }
}

void ModuleManager::unload(const std::string& name) {
    const auto found = modules_.find(name);
    if (found == modules_.end()) return;
    for (const std::string& other : std::vector<std::string>(order_.rbegin(), order_.rend()))
        if (contains(dependencies(other), name)) unload(other);
    Entry& entry = found->second;
    if (entry.registration) entry.kept.save(host_, *entry.registration);
    entry.registration.reset();
    if (entry.library && host_.renderer) host_.renderer->shaders().remove_folder(name);
    entry.library.reset();
    entry.state = ModuleState::available;
    entry.problem.clear();
    std::erase(order_, name);
}

std::vector<std::string> ModuleManager::reload_changed() {
    std::vector<std::string> reloaded;
    for (const fs::path& file : watch_.changed()) {
        const std::string name = file.stem().string();
        if (file.extension() == ".so" && file.parent_path() == folder_ && wanted(name) && reload(name))
            reloaded.push_back(name);
    }
    if (reloaded.empty()) return reloaded;
    for (const ModuleReport& report : reports())
        if (report.state == ModuleState::unresolved_dependency && load(report.name)) reloaded.push_back(report.name);
    return reloaded;
}

bool ModuleManager::loaded(std::string_view name) const {
    const auto entry = modules_.find(std::string(name));
    return entry != modules_.end() && entry->second.registration != nullptr;
}

/// In use, or asked for and broken so far.
bool ModuleManager::wanted(const std::string& name) const {
    const auto entry = modules_.find(name);
    return entry != modules_.end() && entry->second.state != ModuleState::available;
}

/// What a loaded module names; nothing for others.
std::vector<std::string> ModuleManager::dependencies(const std::string& name) const {
    const auto entry = modules_.find(name);
    if (entry == modules_.end() || !entry->second.library) return {};
    return split(entry->second.library->info().depends);
}

/// Whether a loaded module depends on another, be it through others.
bool ModuleManager::leads_to(const std::string& name, const std::string& other) const {
    const std::vector<std::string> names = dependencies(name);
    return std::any_of(names.begin(), names.end(),
                       [&](const std::string& next) { return next == other || leads_to(next, other); });
}

std::vector<ModuleReport> ModuleManager::reports() const {
    std::map<std::string, ModuleReport> all;
    for (const std::string& name : available()) all[name].name = name;
    for (const auto& [name, entry] : modules_) {
        ModuleReport& report = all[name];
        report.name = name;
        report.state = entry.state;
        report.problem = entry.problem;
        if (!entry.registration) continue;
        const ModuleInfo& info = entry.library->info();
        report.version = info.version;
        report.summary = info.summary;
        report.depends = split(info.depends);
        report.components = entry.registration->components();
        report.settings = entry.registration->settings_names();
        report.passes = entry.registration->passes();
        report.seams = entry.registration->seams();
    }
    std::vector<ModuleReport> list;
    for (auto& [name, report] : all) list.push_back(std::move(report));
    return list;
}

std::vector<std::string> ModuleManager::available() const {
    std::vector<std::string> names;
    std::error_code failed;
    for (const auto& entry : fs::directory_iterator(folder_, failed))
        if (entry.path().extension() == ".so") names.push_back(entry.path().stem().string());
    std::sort(names.begin(), names.end());
    return names;
}

fs::path ModuleManager::file(const std::string& name) const {
    return folder_ / (name + ".so");
}

void ModuleManager::check_name(const std::string& name) const {
    const bool plain =
        !name.empty() && name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_") == std::string::npos;
    if (!plain) throw Error("'" + name + "' is no module name (expected lower-case letters, digits and underscores)");
    if (!fs::is_regular_file(file(name)))
        throw Error(Diagnostic{{},
                               "there is no module '" + name + "'",
                               "a module of " + folder_.string(),
                               nearest_name(name, available())});
}

void ModuleManager::check_dependencies(const ModuleLibrary& library) {
    for (const std::string& needed : split(library.info().depends)) {
        if (contains(loading_, needed) || leads_to(needed, library.info().name))
            throw Error("modules depend on each other in a circle through '" + needed + "'");
        if (!load(needed)) throw Error("it needs the module '" + needed + "', which cannot be loaded");
    }
}

std::unique_ptr<Registration> ModuleManager::install(ModuleLibrary& library) {
    const std::string name = library.info().name;
    if (host_.renderer) host_.renderer->shaders().add_folder(name, sources_ / name / "shaders");
    auto registration = std::make_unique<Registration>(host_, name);
    guard_module_call("install", [&] { library.module().install(*registration); });
    return registration;
}

bool ModuleManager::fail(const std::string& name, ModuleState state, const std::exception& error) {
    Entry& entry = modules_[name];
    entry.state = state;
    entry.problem = error.what();
    log::error("module {}: {}{}", name, error.what(),
               state == ModuleState::outdated ? " (the last good build runs on)" : "");
    return false;
}

}  // namespace tyndall
