#pragma once
/// The contract between the engine and a hot-loadable module.
///
/// A module is one shared object, `build/<preset>/modules/NAME.so`, that exports (TYNDALL_MODULE writes both):
///
///     extern "C" const ModuleInfo* tyndall_module_info();   // plain data; read before anything else is called
///     extern "C" Module* tyndall_module_create();           // null or an object that tyndall_module_destroy deletes
///     extern "C" void tyndall_module_destroy(Module*);
///
/// Rules. `install` registers everything through the Registrar and never touches GL. The registrar owns what was
/// registered; unloading is dropping it, then `tyndall_module_destroy`, then dlclose. Nothing of a module outlives
/// that: no vtable, static, std::function, exception or thread. No thread_local with a destructor in a module.
/// Exceptions never cross: the loader catches what `install` throws while the library is still there and keeps only its
/// text.

#include <cstdint>
#include <functional>
#include <memory>
#include <string>

#include "render/frame_graph.h"
#include "render/seams.h"
#include "scene/extraction.h"
#include "scene/settings.h"

namespace tyndall {

/// Changes with every change of a header that modules compile against (made by the build: module/abi.h).
[[nodiscard]] const char* abi_tag();

/// Metadata of a module, plain C data.
struct ModuleInfo {
    const char* abi;       ///< TYNDALL_ABI_TAG that the module was compiled with
    const char* name;      ///< equals the file's name
    const char* version;   ///< of the module
    const char* summary;   ///< one line
    const char* depends;   ///< comma-separated module names that must be loaded first; may be empty
    const char* build_id;  ///< differs between builds
};

/// Where a module registers what it brings. All names must be unique; a taken name is an Error that names its owner.
class Registrar {
 public:
    virtual ~Registrar() = default;

    /// An authoring component and how it becomes part of the RenderScene.
    template <class T>
    void component(Extractor extractor) {
        add_component(describe_struct<T>(std::string(T::kName)), std::move(extractor));
    }
    /// Settings under "render" in scene files.
    template <class T>
    void settings() {
        add_settings(describe_struct<T>(std::string(T::kName)));
    }
    virtual void pass(std::unique_ptr<Pass> pass) = 0;
    virtual void seam(Seam seam, SeamProvider provider) = 0;
    /// Where "NAME/file.glsl" is looked up is set by the loader: the module's shaders/ folder.

 protected:
    virtual void add_component(std::shared_ptr<const StructType> type, Extractor extractor) = 0;
    virtual void add_settings(std::shared_ptr<const StructType> type) = 0;
};

/// What a module implements.
class Module {
 public:
    virtual ~Module() = default;
    virtual void install(Registrar& registrar) = 0;
};

}  // namespace tyndall
