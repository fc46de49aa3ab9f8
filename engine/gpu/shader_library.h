#pragma once
/// GLSL from files: #include, defines, generated text, reload that keeps the last good program.

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "gpu/gpu.h"

namespace tyndall::gpu {

/// What a program is made of. File names are looked up in the library's folders ("render/shaders/light.frag").
struct ProgramDesc {
    std::string name;    ///< for messages and timings
    std::string vertex;  ///< defaults to the full-screen triangle when a fragment shader is given
    std::string geometry;
    std::string fragment;
    std::string compute;
    std::vector<std::string> defines;  ///< "NAME" or "NAME value"
    bool operator==(const ProgramDesc&) const = default;
};

/// Finds, assembles, compiles and keeps programs.
///
/// `#include "physics/phase.glsl"` is resolved in the library's folders (engine/ and those added), once per stage
/// (include guards are not needed), wherever it stands: an #include below an #if is read either way. Every shader gets
/// `#version 450 core`, `#define FN`, `#define OUT(T) out T`, `#define INOUT(T) inout T` and the defines in front; the
/// driver's messages come back with the file and line that they are about. A generated text (`set_text`) is included
/// like a file and shadows one.
class ShaderLibrary {
 public:
    ShaderLibrary();
    ~ShaderLibrary();

    /// Looks for files below `folder` too; "modules/fog" then serves "fog/march.frag" when `prefix` is "fog".
    void add_folder(const std::string& prefix, const std::filesystem::path& folder);
    void remove_folder(const std::string& prefix);
    /// Defines or replaces an included text that is not a file; programs that included it are rebuilt on their next
    /// use.
    void set_text(const std::string& name, std::string text);

    /// A stable reference to the program, built on first use and updated in place by reloads (which reset its
    /// uniforms). Throws Error with file, line and the driver's message when it has never compiled (at once, until one
    /// of its texts changes); keeps the last good one and logs when a change broke it.
    const Program& program(const ProgramDesc& desc);
    /// Drops programs whose name starts with `prefix` (a module that leaves).
    void drop(std::string_view prefix);
    /// Rebuilds programs whose files changed on disk since they were read. Returns how many were rebuilt and are good.
    int reload_changed();
    /// The newest messages of programs that run on their last good version or never compiled; empty when all is well.
    [[nodiscard]] std::string broken() const;

 private:
    struct Implementation;
    std::unique_ptr<Implementation> self_;
};

}  // namespace tyndall::gpu
