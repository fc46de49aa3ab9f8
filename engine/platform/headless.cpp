#include <epoxy/egl.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <cstring>

#include "core/error.h"
#include "platform/context.h"

namespace tyndall::platform {
namespace {

bool has_extension(const char* extensions, std::string_view wanted) {
    std::string_view rest = extensions ? extensions : "";
    while (!rest.empty()) {
        const size_t end = std::min(rest.find(' '), rest.size());
        if (rest.substr(0, end) == wanted) return true;
        rest.remove_prefix(std::min(end + 1, rest.size()));
    }
    return false;
}

/// A display that EGL may offer.
struct Candidate {
    std::string how;
    EGLDisplay display = EGL_NO_DISPLAY;
};

EGLDisplay platform_display(EGLenum platform, void* native) {
    return eglGetPlatformDisplayEXT(platform, native, nullptr);
}

/// GPUs first, then Mesa's surfaceless platform (which finds a GPU or the CPU), then whatever EGL's default is.
std::vector<Candidate> candidates() {
    const char* client = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
    const char* asked = std::getenv("LIBGL_ALWAYS_SOFTWARE");
    const bool cpu_only = asked && std::strcmp(asked, "0") != 0 && std::strcmp(asked, "false") != 0;
    std::vector<Candidate> hardware;
    std::vector<Candidate> software;
    if (has_extension(client, "EGL_EXT_platform_device") && has_extension(client, "EGL_EXT_device_query") &&
        has_extension(client, "EGL_EXT_device_enumeration")) {
        std::array<EGLDeviceEXT, 16> devices{};
        EGLint count = 0;
        eglQueryDevicesEXT(static_cast<EGLint>(devices.size()), devices.data(), &count);
        for (size_t i = 0; i < static_cast<size_t>(count); ++i) {
            const bool cpu =
                has_extension(eglQueryDeviceStringEXT(devices[i], EGL_EXTENSIONS), "EGL_MESA_device_software");
            if (cpu_only && !cpu) continue;
            (cpu ? software : hardware)
                .push_back({fmt::format("EGL device {}", i), platform_display(EGL_PLATFORM_DEVICE_EXT, devices[i])});
        }
    }
    std::vector<Candidate> out = std::move(hardware);
    if (has_extension(client, "EGL_MESA_platform_surfaceless"))
        out.push_back({"EGL surfaceless", platform_display(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY)});
    out.insert(out.end(), software.begin(), software.end());
    out.push_back({"EGL default display", eglGetDisplay(EGL_DEFAULT_DISPLAY)});
    return out;
}

/// Why EGL just said no.
std::string egl_reason() {
    switch (const EGLint error = eglGetError()) {
        case EGL_SUCCESS:
            return "no reason given";
        case EGL_NOT_INITIALIZED:
            return "the display could not be initialised";
        case EGL_BAD_MATCH:
            return "the version or configuration is not offered";
        case EGL_BAD_ALLOC:
            return "out of resources";
        default:
            return fmt::format("EGL error 0x{:x}", error);
    }
}

/// One EGL display, context and, where needed, a pixel buffer of one pixel.
class HeadlessContext final : public Context {
 public:
    HeadlessContext(const Candidate& candidate, const ContextOptions& options) : display_(candidate.display) {
        try {
            open(options);
            adopt(candidate.how, options);
        } catch (...) {
            close();
            throw;
        }
    }
    ~HeadlessContext() override { close(); }

    void make_current() override {
        if (!eglMakeCurrent(display_, surface_, surface_, context_))
            throw Error("the GL context cannot be made current: " + egl_reason());
    }

 private:
    void open(const ContextOptions& options) {
        if (display_ == EGL_NO_DISPLAY || !eglInitialize(display_, nullptr, nullptr)) throw Error(egl_reason());
        if (!eglBindAPI(EGL_OPENGL_API)) throw Error("EGL offers no desktop OpenGL");
        const bool surfaceless = has_extension(eglQueryString(display_, EGL_EXTENSIONS), "EGL_KHR_surfaceless_context");
        const std::array<EGLint, 5> wanted{EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_SURFACE_TYPE,
                                           surfaceless ? 0 : EGL_PBUFFER_BIT, EGL_NONE};
        EGLConfig config = nullptr;
        EGLint count = 0;
        if (!eglChooseConfig(display_, wanted.data(), &config, 1, &count) || count < 1)
            throw Error("EGL offers no configuration for OpenGL");
        create_context(config, options);
        if (!surfaceless) {
            constexpr std::array<EGLint, 5> kPixel{EGL_WIDTH, 1, EGL_HEIGHT, 1, EGL_NONE};
            surface_ = eglCreatePbufferSurface(display_, config, kPixel.data());
        }
        make_current();
    }

    void create_context(EGLConfig config, const ContextOptions& options) {
        const std::array<EGLint, 9> core{EGL_CONTEXT_MAJOR_VERSION,
                                         4,
                                         EGL_CONTEXT_MINOR_VERSION,
                                         5,
                                         EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                         EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                         EGL_CONTEXT_OPENGL_DEBUG,
                                         options.debug ? EGL_TRUE : EGL_FALSE,
                                         EGL_NONE};
        context_ = eglCreateContext(display_, config, EGL_NO_CONTEXT, core.data());
        // Any context will do to say what the driver has instead.
        if (context_ == EGL_NO_CONTEXT) context_ = eglCreateContext(display_, config, EGL_NO_CONTEXT, nullptr);
        if (context_ == EGL_NO_CONTEXT) throw Error("no OpenGL context: " + egl_reason());
    }

    /// The display itself stays initialised: EGL shares it between all who ask for it.
    void close() {
        if (context_ == EGL_NO_CONTEXT) return;
        eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        if (surface_ != EGL_NO_SURFACE) eglDestroySurface(display_, surface_);
        eglDestroyContext(display_, context_);
    }

    EGLDisplay display_;
    EGLSurface surface_ = EGL_NO_SURFACE;
    EGLContext context_ = EGL_NO_CONTEXT;
};

}  // namespace

std::unique_ptr<Context> create_headless_context(const ContextOptions& options) {
    std::vector<Diagnostic> tried;
    for (const Candidate& candidate : candidates()) {
        try {
            return std::make_unique<HeadlessContext>(candidate, options);
        } catch (const Error& error) {
            tried.push_back(error.diagnostics().front());
            tried.back().message = candidate.how + ": " + tried.back().message;
        }
    }
    throw Error(std::move(tried)).within("making an OpenGL 4.5 core context without a display");
}

}  // namespace tyndall::platform
