#include "module/library.h"

#include <dlfcn.h>
#include <unistd.h>

#include <atomic>
#include <system_error>

namespace tyndall {
namespace fs = std::filesystem;
namespace {

fs::path unique_copy(const fs::path& file) {
    static std::atomic<unsigned> generation{0};
    const fs::path copy = fs::temp_directory_path() / ("tyndall_" + std::to_string(getpid()) + "_" +
                                                       std::to_string(generation++) + "_" + file.filename().string());
    std::error_code failed;
    fs::copy_file(file, copy, fs::copy_options::overwrite_existing, failed);
    if (failed)
        throw Error(Diagnostic{{file.string()}, "cannot copy the module before loading it: " + failed.message()});
    return copy;
}

template <class F>
F* entry_point(void* handle, const char* name) {
    void* symbol = dlsym(handle, name);
    if (!symbol) throw Error(std::string("it has no entry point '") + name + "' (TYNDALL_MODULE exports it)");
    return reinterpret_cast<F*>(symbol);
}

}  // namespace

ModuleLibrary::ModuleLibrary(const fs::path& file, const std::string& name) {
    open(file);
    try {
        info_ = entry_point<const ModuleInfo*()>(handle_, "tyndall_module_info")();
        check(name);
        destroy_ = entry_point<void(Module*)>(handle_, "tyndall_module_destroy");
        auto* create = entry_point<Module*()>(handle_, "tyndall_module_create");
        guard_module_call("its constructor", [&] { module_ = create(); });
        if (!module_) throw Error("it made no module object");
    } catch (Error& error) {
        dlclose(handle_);
        throw error.within("module " + name);
    }
}

ModuleLibrary::~ModuleLibrary() {
    destroy_(module_);
    dlclose(handle_);
}

void ModuleLibrary::open(const fs::path& file) {
    const fs::path copy = unique_copy(file);
    handle_ = dlopen(copy.c_str(), RTLD_NOW | RTLD_LOCAL);
    const char* reason = handle_ ? nullptr : dlerror();
    std::error_code ignored;
    fs::remove(copy, ignored);
    if (handle_) return;
    std::string text = reason ? reason : "unknown reason";
    if (const size_t at = text.find(copy.string()); at != std::string::npos)
        text.replace(at, copy.string().size(), file.filename().string());
    throw Error(Diagnostic{{file.string()}, "cannot load the module: " + text});
}

void ModuleLibrary::check(const std::string& name) const {
    if (std::string(info_->abi) != abi_tag())
        throw Error(std::string("it was built against another engine (ABI ") + info_->abi + ", this program has " +
                    abi_tag() + "); rebuild it");
    if (info_->name != name) throw Error(std::string("the library calls itself '") + info_->name + "'");
}

}  // namespace tyndall
