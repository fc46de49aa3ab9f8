#include "platform/context.h"

#include <epoxy/gl.h>
#include <fmt/format.h>
#include <malloc.h>

#include <utility>

#include "core/error.h"
#include "core/log.h"

namespace tyndall::platform {
namespace {

constexpr size_t kKeptMessages = 100;  // a broken frame repeats itself

std::string text_of(GLenum what) {
    const GLubyte* text = glGetString(what);
    return text ? reinterpret_cast<const char*>(text) : "unknown";
}

int limit(GLenum what) {
    GLint value = 0;
    glGetIntegerv(what, &value);
    return value;
}

bool is_software(std::string_view renderer) {
    for (const std::string_view name : {"llvmpipe", "softpipe", "SwiftShader"})
        if (renderer.find(name) != std::string_view::npos) return true;
    return false;
}

/// A software renderer takes and frees the memory of its draws every frame. Left to itself glibc hands large blocks
/// back to the kernel each time, and faulting their pages in again costs several times the drawing of small pictures.
void keep_freed_memory() {
#ifdef __GLIBC__
    mallopt(M_MMAP_THRESHOLD, 32 << 20);
    mallopt(M_TRIM_THRESHOLD, 256 << 20);
    mallopt(M_TOP_PAD, 16 << 20);
#endif
}

/// Performance hints are no errors, and a shader compiler's messages reach people through gpu::ShaderLibrary.
bool is_noise(GLenum source, GLenum type, GLenum severity) {
    return source == GL_DEBUG_SOURCE_SHADER_COMPILER || type == GL_DEBUG_TYPE_PERFORMANCE ||
           type == GL_DEBUG_TYPE_PUSH_GROUP || type == GL_DEBUG_TYPE_POP_GROUP ||
           (severity != GL_DEBUG_SEVERITY_HIGH && severity != GL_DEBUG_SEVERITY_MEDIUM);
}

}  // namespace

std::string GlInfo::text() const {
    return fmt::format(
        "renderer        {}{}\nvendor          {}\nOpenGL          {}\nGLSL            {}\ncontext         {}\n"
        "textures        {} wide, {} volume, {} layers, {} units\ncolour targets  {}\nimage units     {}\n"
        "shared memory   {} bytes a compute group",
        renderer, software ? " (software)" : "", vendor, version, glsl_version, how, max_texture_size, max_volume_size,
        max_array_layers, max_texture_units, max_colour_targets, max_image_units, max_compute_shared_bytes);
}

struct Context::DebugLog {
    std::vector<std::string> messages;

    static void APIENTRY receive(GLenum source, GLenum type, GLuint id, GLenum severity, GLsizei length,
                                 const GLchar* message, const void* user) {
        if (is_noise(source, type, severity)) return;
        auto& messages = static_cast<DebugLog*>(const_cast<void*>(user))->messages;
        if (messages.size() >= kKeptMessages) return;
        messages.push_back(fmt::format("GL {}: {}", id, std::string_view(message, static_cast<size_t>(length))));
        log::warning("{}", messages.back());
    }
};

Context::Context() = default;
Context::~Context() = default;

void Context::adopt(std::string_view how, const ContextOptions& options) {
    info_.vendor = text_of(GL_VENDOR);
    info_.renderer = text_of(GL_RENDERER);
    info_.version = text_of(GL_VERSION);
    info_.how = how;
    info_.software = is_software(info_.renderer);
    if (info_.software) keep_freed_memory();
    const int version = epoxy_gl_version();
    if (version < 45)
        throw Error(Diagnostic{{},
                               fmt::format("this driver gives OpenGL {}.{} ({}, {})", version / 10, version % 10,
                                           info_.renderer, info_.version),
                               "OpenGL 4.5 core: a newer driver, or Mesa's software renderer",
                               {}});
    info_.major = version / 10;
    info_.minor = version % 10;
    info_.glsl_version = text_of(GL_SHADING_LANGUAGE_VERSION);
    info_.max_texture_size = limit(GL_MAX_TEXTURE_SIZE);
    info_.max_volume_size = limit(GL_MAX_3D_TEXTURE_SIZE);
    info_.max_array_layers = limit(GL_MAX_ARRAY_TEXTURE_LAYERS);
    info_.max_colour_targets = limit(GL_MAX_DRAW_BUFFERS);
    info_.max_texture_units = limit(GL_MAX_COMBINED_TEXTURE_IMAGE_UNITS);
    info_.max_image_units = limit(GL_MAX_IMAGE_UNITS);
    info_.max_compute_shared_bytes = limit(GL_MAX_COMPUTE_SHARED_MEMORY_SIZE);
    if (!options.debug) return;
    debug_log_ = std::make_unique<DebugLog>();
    glEnable(GL_DEBUG_OUTPUT);
    glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);  // the call stack of a complaint is that of the call
    glDebugMessageCallback(&DebugLog::receive, debug_log_.get());
}

std::vector<std::string> Context::take_debug_messages() {
    return debug_log_ ? std::exchange(debug_log_->messages, {}) : std::vector<std::string>{};
}

}  // namespace tyndall::platform
