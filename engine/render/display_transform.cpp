#include "render/display_transform.h"

#include <epoxy/gl.h>

#include "core/error.h"
#include "core/log.h"

namespace tyndall {
namespace {

unsigned int upload(const DisplayShader::Lut& lut) {
    const GLenum target = lut.dimensions == 1 ? GL_TEXTURE_1D : lut.dimensions == 2 ? GL_TEXTURE_2D : GL_TEXTURE_3D;
    const GLenum format = lut.channels == 1 ? GL_RED : GL_RGB;
    const GLenum internal = lut.channels == 1 ? GL_R32F : GL_RGB32F;
    const float* values = lut.values.data();
    GLuint texture = 0;
    glCreateTextures(target, 1, &texture);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    if (lut.dimensions == 1) {
        glTextureStorage1D(texture, 1, internal, lut.width);
        glTextureSubImage1D(texture, 0, 0, lut.width, format, GL_FLOAT, values);
    } else if (lut.dimensions == 2) {
        glTextureStorage2D(texture, 1, internal, lut.width, lut.height);
        glTextureSubImage2D(texture, 0, 0, 0, lut.width, lut.height, format, GL_FLOAT, values);
    } else {
        glTextureStorage3D(texture, 1, internal, lut.width, lut.width, lut.width);
        glTextureSubImage3D(texture, 0, 0, 0, 0, lut.width, lut.width, lut.width, format, GL_FLOAT, values);
    }
    return texture;
}

void set_uniform(const gpu::Program& program, const DisplayShader::Uniform& uniform) {
    using Kind = DisplayShader::Uniform::Kind;
    const GLint at = glGetUniformLocation(program.name(), uniform.name.c_str());
    if (at < 0) return;
    switch (uniform.kind) {
        case Kind::float1:
            glUniform1f(at, uniform.floats[0]);
            break;
        case Kind::bool1:
            glUniform1i(at, uniform.ints[0]);
            break;
        case Kind::float3:
            glUniform3fv(at, 1, uniform.floats.data());
            break;
        case Kind::float_array:
            glUniform1fv(at, GLsizei(uniform.floats.size()), uniform.floats.data());
            break;
        case Kind::ivec2_array:
            glUniform2iv(at, GLsizei(uniform.ints.size() / 2), uniform.ints.data());
            break;
    }
}

}  // namespace

DisplayTransform::DisplayTransform(const ColorConfig& config, gpu::ShaderLibrary& shaders)
    : config_(config), shaders_(shaders) {
    set({}, {});
}

DisplayTransform::~DisplayTransform() {
    release_tables();
}

void DisplayTransform::release_tables() {
    glDeleteTextures(GLsizei(tables_.size()), tables_.data());
    tables_.clear();
}

void DisplayTransform::set(const std::string& display, const std::string& view) {
    shader_ = config_.display_shader(display, view);  // throws before anything has changed
    display_ = display;
    view_ = view;
    shaders_.set_text("render/display_transform.glsl", shader_.text);
    release_tables();
}

void DisplayTransform::reload() {
    try {
        set(display_, view_);
    } catch (const Error& error) {
        log::warning("the configuration's default view is used: {}", error.what());
        set({}, {});
    }
}

void DisplayTransform::upload_tables() {
    for (const DisplayShader::Lut& lut : shader_.luts) tables_.push_back(upload(lut));
}

void DisplayTransform::bind(const gpu::Program& program) {
    if (tables_.empty()) upload_tables();
    for (const DisplayShader::Uniform& uniform : shader_.uniforms) set_uniform(program, uniform);
    for (size_t i = 0; i < tables_.size(); ++i) {
        const auto filter = shader_.luts[i].linear ? gpu::Filter::linear : gpu::Filter::nearest;
        program.texture(shader_.luts[i].sampler, tables_[i], gpu::sampler({.filter = filter}));
    }
}

}  // namespace tyndall
