#include <epoxy/gl.h>

#include <algorithm>

#include "gpu/gpu.h"

namespace tyndall::gpu {
namespace {

/// Objects that any draw may share; made when first needed, on the context's thread.
struct Shared {
    std::vector<std::pair<SamplerDesc, GLuint>> samplers;  // a dozen at most: searched in order
    GLuint empty_vertex_array = 0;
};

Shared& shared() {
    static Shared instance;
    return instance;
}

GLint wrap_of(Wrap wrap) {
    switch (wrap) {
        case Wrap::repeat:
            return GL_REPEAT;
        case Wrap::mirror:
            return GL_MIRRORED_REPEAT;
        case Wrap::clamp:
            return GL_CLAMP_TO_EDGE;
        case Wrap::border_zero:
            return GL_CLAMP_TO_BORDER;
    }
    return GL_CLAMP_TO_EDGE;
}

GLuint create(const SamplerDesc& desc) {
    GLuint name = 0;
    glCreateSamplers(1, &name);
    const bool smooth = desc.filter != Filter::nearest;
    const GLint minify = desc.filter == Filter::trilinear ? GL_LINEAR_MIPMAP_LINEAR : (smooth ? GL_LINEAR : GL_NEAREST);
    glSamplerParameteri(name, GL_TEXTURE_MIN_FILTER, minify);
    glSamplerParameteri(name, GL_TEXTURE_MAG_FILTER, smooth ? GL_LINEAR : GL_NEAREST);
    glSamplerParameteri(name, GL_TEXTURE_WRAP_S, wrap_of(desc.wrap_u));
    glSamplerParameteri(name, GL_TEXTURE_WRAP_T, wrap_of(desc.wrap_v));
    glSamplerParameteri(name, GL_TEXTURE_WRAP_R, wrap_of(desc.wrap_v));
    if (desc.compare) {
        glSamplerParameteri(name, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
        glSamplerParameteri(name, GL_TEXTURE_COMPARE_FUNC, GL_GEQUAL);
    }
    if (desc.anisotropy > 1.0f && epoxy_has_gl_extension("GL_EXT_texture_filter_anisotropic")) {
        GLfloat largest = 1.0f;
        glGetFloatv(GL_MAX_TEXTURE_MAX_ANISOTROPY_EXT, &largest);
        glSamplerParameterf(name, GL_TEXTURE_MAX_ANISOTROPY_EXT, std::min(desc.anisotropy, largest));
    }
    return name;
}

}  // namespace

unsigned int sampler(const SamplerDesc& desc) {
    auto& samplers = shared().samplers;
    const auto known = std::ranges::find(samplers, desc, &std::pair<SamplerDesc, GLuint>::first);
    if (known != samplers.end()) return known->second;
    return samplers.emplace_back(desc, create(desc)).second;
}

void release_samplers() {
    for (const auto& [desc, name] : shared().samplers) glDeleteSamplers(1, &name);
    if (shared().empty_vertex_array != 0) glDeleteVertexArrays(1, &shared().empty_vertex_array);
    shared() = {};
}

void draw_fullscreen() {
    if (shared().empty_vertex_array == 0) glCreateVertexArrays(1, &shared().empty_vertex_array);
    glBindVertexArray(shared().empty_vertex_array);
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

}  // namespace tyndall::gpu
