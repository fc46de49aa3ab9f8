#pragma once
/// The contract between the engine and a hot-loadable module.
///
/// A module is one shared object, `build/<preset>/modules/NAME.so`. `TYNDALL_MODULE(MyModule, "0.1", "One line.", "")`
/// at the end of one of its sources exports
///
///     extern "C" const ModuleInfo* tyndall_module_info();   // plain data; read before anything else is called
///     extern "C" Module* tyndall_module_create();           // an object that tyndall_module_destroy deletes
///     extern "C" void tyndall_module_destroy(Module*);
///
/// Rules. `install` registers everything through the Registrar and never touches GL: the path tracer, the schema and
/// validation load modules with no context. The registrar owns what was registered; unloading is dropping it, then
/// `tyndall_module_destroy`, then dlclose. Nothing of a module outlives that: no vtable, static, std::function,
/// exception or thread; no thread_local with a destructor. Exceptions never cross: the loader catches what `install`
/// throws while the library is still there and keeps only its text.

#include <functional>
#include <memory>
#include <string>

#include "core/error.h"
#include "module/abi.h"
#include "render/frame_graph.h"
#include "render/seams.h"
#include "scene/extraction.h"
#include "scene/settings.h"

namespace tyndall {

/// Metadata of a module, plain C data.
struct ModuleInfo {
    const char* abi;      ///< TYNDALL_ABI_TAG that the module was compiled with
    const char* name;     ///< equals the file's name
    const char* version;  ///< of the module
    const char* summary;  ///< one line
    const char* depends;  ///< comma-separated modules that must be loaded first; may be empty
};

/// Where a module registers what it brings. A name that is taken is an Error that names its owner.
class Registrar {
 public:
    virtual ~Registrar() = default;

    /// An authoring component, and how it becomes part of the RenderScene.
    template <class T>
    void component(Extractor extractor) {
        add_component(describe_struct<T>(std::string(T::kName)), std::move(extractor));
    }
    /// Settings under "render" in scene files. The object that is returned holds their present values as long as the
    /// module is installed. Passes may declare targets by them: the frame graph is built again when a setting changes.
    template <class T>
    const T& settings() {
        return *static_cast<const T*>(add_settings(describe_struct<T>(std::string(T::kName))));
    }
    /// A node of the frame graph; its name starts with the module's: "fog.march". Run in both render paths.
    virtual void pass(std::unique_ptr<Pass> pass) = 0;
    /// A provider of a seam. Its GLSL lies in the module's shaders/ folder and is named "MODULE/file.glsl".
    virtual void seam(Seam seam, SeamProvider provider) = 0;

 protected:
    virtual void add_component(std::shared_ptr<const StructType> type, Extractor extractor) = 0;
    virtual const void* add_settings(std::shared_ptr<const StructType> type) = 0;
};

/// What a module implements.
class Module {
 public:
    virtual ~Module() = default;
    /// Called once after loading, and again when a newer version could not take over.
    virtual void install(Registrar& registrar) = 0;
};

}  // namespace tyndall

/// Exports the class as this library's module. TYNDALL_MODULE_NAME is set by the build (tyndall_module in CMake).
#define TYNDALL_MODULE(Type, version, summary, depends)                                                             \
    extern "C" __attribute__((visibility("default"))) const tyndall::ModuleInfo* tyndall_module_info() {            \
        static constexpr tyndall::ModuleInfo info{TYNDALL_ABI_TAG, TYNDALL_MODULE_NAME, version, summary, depends}; \
        return &info;                                                                                               \
    }                                                                                                               \
    extern "C" __attribute__((visibility("default"))) tyndall::Module* tyndall_module_create() {                    \
        return new Type;                                                                                            \
    }                                                                                                               \
    extern "C" __attribute__((visibility("default"))) void tyndall_module_destroy(tyndall::Module* module) {        \
        delete module;                                                                                              \
    }
