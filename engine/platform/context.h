#pragma once
/// An OpenGL 4.5 core context: headless here, in a window in window.h.

#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace tyndall::platform {

/// What the driver says it is and can do.
struct GlInfo {
    std::string vendor;
    std::string renderer;
    std::string version;       ///< the driver's own text ("4.5 (Core Profile) Mesa 22.3.6")
    std::string glsl_version;  ///< likewise
    std::string how;           ///< how the context was made ("EGL surfaceless", "GLFW window")
    int major = 0;
    int minor = 0;
    bool software = false;  ///< shading runs on the CPU (llvmpipe and its like)
    int max_texture_size = 0;
    int max_volume_size = 0;
    int max_array_layers = 0;
    int max_colour_targets = 0;
    int max_texture_units = 0;  ///< of all stages together
    int max_image_units = 0;
    int max_compute_shared_bytes = 0;

    /// A few lines for people ("renderer  llvmpipe ...").
    [[nodiscard]] std::string text() const;
};

struct ContextOptions {
    /// Asks the driver to check every call; what it finds is logged and kept for take_debug_messages().
    bool debug = false;
};

/// A GL context, current on the thread that made it. All GL objects must be gone before it goes.
class Context {
 public:
    virtual ~Context();
    Context(const Context&) = delete;
    Context& operator=(const Context&) = delete;

    virtual void make_current() = 0;
    [[nodiscard]] const GlInfo& gl_info() const { return info_; }
    /// What the driver complained about since the last call: errors and undefined or deprecated behaviour. Not
    /// included: notes, performance hints, and shader compilers' messages (gpu::ShaderLibrary reports those). Empty
    /// without ContextOptions::debug.
    [[nodiscard]] std::vector<std::string> take_debug_messages();

 protected:
    Context();
    /// For the derived constructor, with the context current: checks the version, reads the limits, listens to the
    /// driver. Throws Error naming what was found and what is needed.
    void adopt(std::string_view how, const ContextOptions& options);

 private:
    struct DebugLog;
    GlInfo info_;
    std::unique_ptr<DebugLog> debug_log_;
};

/// A context with no display and no default framebuffer: on a GPU where EGL offers one, else on the CPU
/// (LIBGL_ALWAYS_SOFTWARE=1 asks for the CPU). Throws Error naming each way that was tried.
[[nodiscard]] std::unique_ptr<Context> create_headless_context(const ContextOptions& options = {});

}  // namespace tyndall::platform
