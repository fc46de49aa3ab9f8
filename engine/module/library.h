#pragma once
/// One loaded generation of a module's shared object.

#include <filesystem>
#include <memory>
#include <string>

#include "module/module.h"

namespace tyndall {

/// Owns a dlopen handle and the module object made from it. Loads from a copy under a unique name, so that a rebuilt
/// file is never mistaken for the one in use; the copy is deleted as soon as it is mapped.
class ModuleLibrary {
 public:
    /// Throws Error: no such file, not a library, cut short, entry points missing, another ABI or another name. Runs no
    /// code of the module but its statics and tyndall_module_info.
    ModuleLibrary(const std::filesystem::path& file, const std::string& name);
    ~ModuleLibrary();
    ModuleLibrary(const ModuleLibrary&) = delete;
    ModuleLibrary& operator=(const ModuleLibrary&) = delete;

    /// Makes the module object, once what it depends on is there. Throws Error when its constructor does.
    void create();
    /// After `create`.
    [[nodiscard]] Module& module() const { return *module_; }
    [[nodiscard]] const ModuleInfo& info() const { return *info_; }

 private:
    void open(const std::filesystem::path& file);
    void check(const std::string& name) const;
    void* handle_ = nullptr;
    const ModuleInfo* info_ = nullptr;
    Module* (*create_)() = nullptr;
    Module* module_ = nullptr;
    void (*destroy_)(Module*) = nullptr;
};

/// Calls `f` and turns whatever it throws into an Error that stays valid when the library of the thrown type is gone.
template <class F>
void guard_module_call(const char* what, F&& f) {
    std::string text;
    try {
        f();
        return;
    } catch (const std::exception& e) {
        text = e.what();
    } catch (...) {
        text = "something that is no std::exception";
    }
    throw Error(std::string(what) + " threw: " + text);
}

}  // namespace tyndall
