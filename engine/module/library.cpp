#include "module/library.h"

#include <dlfcn.h>
#include <elf.h>
#include <unistd.h>

#include <atomic>
#include <cstring>
#include <fstream>
#include <system_error>

namespace tyndall {
namespace fs = std::filesystem;
namespace {

/// A copy of a file under a name that no other has, for as long as it takes to map it.
class UniqueCopy {
 public:
    explicit UniqueCopy(const fs::path& file) {
        static std::atomic<unsigned> generation{0};
        path_ = fs::temp_directory_path() / ("tyndall_" + std::to_string(getpid()) + "_" +
                                             std::to_string(generation++) + "_" + file.filename().string());
        std::error_code failed;
        fs::copy_file(file, path_, fs::copy_options::overwrite_existing, failed);
        if (!failed) return;
        remove();
        throw Error(Diagnostic{{file.string()}, "cannot copy the module before loading it: " + failed.message()});
    }
    ~UniqueCopy() { remove(); }
    UniqueCopy(const UniqueCopy&) = delete;
    UniqueCopy& operator=(const UniqueCopy&) = delete;
    [[nodiscard]] const fs::path& path() const { return path_; }

 private:
    void remove() {
        std::error_code ignored;
        fs::remove(path_, ignored);
    }
    fs::path path_;
};

/// Refuses what the system's loader would trust: it maps a file that was cut short and dies on touching what is
/// missing. The table of sections comes last in a library, so a whole one reaches to its end.
void check_whole(const fs::path& copy, const fs::path& file) {
    Elf64_Ehdr header{};
    std::ifstream in(copy, std::ios::binary);
    in.read(reinterpret_cast<char*>(&header), sizeof header);
    const auto got = static_cast<size_t>(in.gcount());
    if (got < SELFMAG || std::memcmp(header.e_ident, ELFMAG, SELFMAG) != 0)
        throw Error(Diagnostic{{file.string()}, "is no shared library", "an ELF file as tyndall_module builds it", {}});
    const uint64_t size = fs::file_size(copy);
    const uint64_t table = uint64_t{header.e_shnum} * header.e_shentsize;
    if (got < sizeof header || header.e_shoff > size || table > size - header.e_shoff)
        throw Error(Diagnostic{{file.string()}, "is cut short after " + std::to_string(size) + " bytes", {}, {}});
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
        if (!info_ || !info_->abi || !info_->name) throw Error("tyndall_module_info() gives no metadata");
        check(name);
        destroy_ = entry_point<void(Module*)>(handle_, "tyndall_module_destroy");
        create_ = entry_point<Module*()>(handle_, "tyndall_module_create");
    } catch (const Error&) {
        dlclose(handle_);
        throw;
    }
}

void ModuleLibrary::create() {
    guard_module_call("its constructor", [&] { module_ = create_(); });
    if (!module_) throw Error("it made no module object");
}

ModuleLibrary::~ModuleLibrary() {
    if (module_) destroy_(module_);
    dlclose(handle_);
}

void ModuleLibrary::open(const fs::path& file) {
    const UniqueCopy copy(file);
    check_whole(copy.path(), file);
    handle_ = dlopen(copy.path().c_str(), RTLD_NOW | RTLD_LOCAL);
    if (handle_) return;
    const char* reason = dlerror();
    std::string text = reason ? reason : "unknown reason";
    const std::string name = copy.path().string();
    if (const size_t at = text.find(name); at != std::string::npos)
        text.replace(at, name.size(), file.filename().string());
    throw Error(Diagnostic{{file.string()}, "cannot load the module: " + text});
}

void ModuleLibrary::check(const std::string& name) const {
    if (std::string(info_->abi) != abi_tag())
        throw Error(std::string("it was built against another engine (ABI ") + info_->abi + ", this program has " +
                    abi_tag() + "); rebuild it");
    if (info_->name != name) throw Error(std::string("the library calls itself '") + info_->name + "'");
}

}  // namespace tyndall
