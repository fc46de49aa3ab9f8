#include <epoxy/gl.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <glm/gtc/type_ptr.hpp>

#include "core/error.h"
#include "gpu/accounting.h"
#include "gpu/format.h"
#include "gpu/gpu.h"

namespace tyndall::gpu {
namespace {

bool is_sampler(GLenum type) {
    switch (type) {
        case GL_SAMPLER_1D:
        case GL_SAMPLER_2D:
        case GL_SAMPLER_3D:
        case GL_SAMPLER_CUBE:
        case GL_SAMPLER_2D_SHADOW:
        case GL_SAMPLER_CUBE_SHADOW:
        case GL_SAMPLER_2D_ARRAY:
        case GL_SAMPLER_2D_ARRAY_SHADOW:
        case GL_SAMPLER_CUBE_MAP_ARRAY:
        case GL_SAMPLER_CUBE_MAP_ARRAY_SHADOW:
        case GL_SAMPLER_BUFFER:
        case GL_INT_SAMPLER_2D:
        case GL_INT_SAMPLER_3D:
        case GL_UNSIGNED_INT_SAMPLER_2D:
        case GL_UNSIGNED_INT_SAMPLER_3D:
        case GL_UNSIGNED_INT_SAMPLER_2D_ARRAY:
            return true;
        default:
            return false;
    }
}

bool is_image(GLenum type) {
    switch (type) {
        case GL_IMAGE_2D:
        case GL_IMAGE_3D:
        case GL_IMAGE_CUBE:
        case GL_IMAGE_2D_ARRAY:
        case GL_IMAGE_CUBE_MAP_ARRAY:
        case GL_UNSIGNED_INT_IMAGE_2D:
        case GL_UNSIGNED_INT_IMAGE_3D:
        case GL_UNSIGNED_INT_IMAGE_2D_ARRAY:
            return true;
        default:
            return false;
    }
}

int resources(GLuint program, GLenum interface, GLenum what) {
    GLint value = 0;
    glGetProgramInterfaceiv(program, interface, what, &value);
    return value;
}

std::string resource_name(GLuint program, GLenum interface, int index, std::vector<char>& scratch) {
    GLsizei length = 0;
    glGetProgramResourceName(program, interface, static_cast<GLuint>(index), static_cast<GLsizei>(scratch.size()),
                             &length, scratch.data());
    return {scratch.data(), static_cast<size_t>(length)};
}

void require_units(std::string_view what, int used, GLenum limit) {
    GLint offered = 0;
    glGetIntegerv(limit, &offered);
    if (used > offered) throw Error(fmt::format("a program uses {} {}; this driver offers {}", used, what, offered));
}

}  // namespace

Program::Program(unsigned int linked) : Handle(linked) {
    tally().programs += 1;
    try {
        reflect_uniforms();
        reflect_blocks(GL_UNIFORM_BLOCK, Slot::Kind::uniform_block);
        reflect_blocks(GL_SHADER_STORAGE_BLOCK, Slot::Kind::storage_block);
    } catch (...) {
        *this = Program();  // the destructor does not run for what threw in its constructor
        throw;
    }
    std::ranges::sort(slots_, {}, &Slot::name);
}

Program::~Program() {
    if (name_ == 0) return;
    glDeleteProgram(name_);
    tally().programs -= 1;
}

void Program::reflect_uniforms() {
    std::vector<char> scratch(static_cast<size_t>(resources(name_, GL_UNIFORM, GL_MAX_NAME_LENGTH)) + 1);
    int samplers = 0;
    int images = 0;
    const auto add = [&](std::string name, int location, GLenum type) {
        Slot slot{std::move(name), location, -1, Slot::Kind::value};
        if (is_sampler(type)) {
            slot.kind = Slot::Kind::sampler;
            slot.unit = samplers++;
        } else if (is_image(type)) {
            slot.kind = Slot::Kind::image;
            slot.unit = images++;
        }
        if (slot.unit >= 0) glProgramUniform1i(name_, location, slot.unit);
        slots_.push_back(std::move(slot));
    };
    for (int i = 0; i < resources(name_, GL_UNIFORM, GL_ACTIVE_RESOURCES); ++i) {
        constexpr std::array<GLenum, 3> kAsked{GL_TYPE, GL_LOCATION, GL_ARRAY_SIZE};
        std::array<GLint, 3> got{};
        glGetProgramResourceiv(name_, GL_UNIFORM, static_cast<GLuint>(i), 3, kAsked.data(), 3, nullptr, got.data());
        const auto [type, location, count] = got;
        if (location < 0) continue;  // lives in a block
        std::string name = resource_name(name_, GL_UNIFORM, i, scratch);
        if (!name.ends_with("[0]")) {
            add(std::move(name), location, static_cast<GLenum>(type));
            continue;
        }
        name.resize(name.size() - 3);
        for (int element = 0; element < count; ++element)
            add(fmt::format("{}[{}]", name, element), location + element, static_cast<GLenum>(type));
        slots_.push_back(slots_[slots_.size() - static_cast<size_t>(count)]);
        slots_.back().name = name;
    }
    require_units("texture units", samplers, GL_MAX_COMBINED_TEXTURE_IMAGE_UNITS);
    require_units("image units", images, GL_MAX_IMAGE_UNITS);
}

void Program::reflect_blocks(unsigned int interface, Slot::Kind kind) {
    std::vector<char> scratch(static_cast<size_t>(resources(name_, interface, GL_MAX_NAME_LENGTH)) + 1);
    const int count = resources(name_, interface, GL_ACTIVE_RESOURCES);
    const bool uniform = kind == Slot::Kind::uniform_block;
    require_units(uniform ? "uniform blocks" : "storage blocks", count,
                  uniform ? GL_MAX_UNIFORM_BUFFER_BINDINGS : GL_MAX_SHADER_STORAGE_BUFFER_BINDINGS);
    for (int i = 0; i < count; ++i) {
        const auto index = static_cast<GLuint>(i);
        if (uniform)
            glUniformBlockBinding(name_, index, index);
        else
            glShaderStorageBlockBinding(name_, index, index);
        slots_.push_back({resource_name(name_, interface, i, scratch), -1, i, kind});
    }
}

const Program::Slot* Program::find(std::string_view name, Slot::Kind kind) const {
    auto slot = std::ranges::lower_bound(slots_, name, {}, [](const Slot& s) { return std::string_view(s.name); });
    for (; slot != slots_.end() && slot->name == name; ++slot)
        if (slot->kind == kind) return &*slot;
    return nullptr;
}

int Program::location(std::string_view name) const {
    const Slot* slot = find(name, Slot::Kind::value);
    return slot ? slot->location : -1;  // GL ignores -1
}

bool Program::has(std::string_view uniform) const {
    return std::ranges::any_of(slots_, [&](const Slot& slot) { return slot.name == uniform; });
}

void Program::use() const {
    glUseProgram(name_);
}

void Program::set(std::string_view uniform, int value) const {
    glProgramUniform1i(name_, location(uniform), value);
}
void Program::set(std::string_view uniform, unsigned int value) const {
    glProgramUniform1ui(name_, location(uniform), value);
}
void Program::set(std::string_view uniform, float value) const {
    glProgramUniform1f(name_, location(uniform), value);
}
void Program::set(std::string_view uniform, glm::ivec2 value) const {
    glProgramUniform2iv(name_, location(uniform), 1, glm::value_ptr(value));
}
void Program::set(std::string_view uniform, glm::ivec3 value) const {
    glProgramUniform3iv(name_, location(uniform), 1, glm::value_ptr(value));
}
void Program::set(std::string_view uniform, glm::vec2 value) const {
    glProgramUniform2fv(name_, location(uniform), 1, glm::value_ptr(value));
}
void Program::set(std::string_view uniform, glm::vec3 value) const {
    glProgramUniform3fv(name_, location(uniform), 1, glm::value_ptr(value));
}
void Program::set(std::string_view uniform, glm::vec4 value) const {
    glProgramUniform4fv(name_, location(uniform), 1, glm::value_ptr(value));
}
void Program::set(std::string_view uniform, const glm::mat3& value) const {
    glProgramUniformMatrix3fv(name_, location(uniform), 1, GL_FALSE, glm::value_ptr(value));
}
void Program::set(std::string_view uniform, const glm::mat4& value) const {
    glProgramUniformMatrix4fv(name_, location(uniform), 1, GL_FALSE, glm::value_ptr(value));
}

void Program::texture(std::string_view name, const Texture& texture, const SamplerDesc& desc) const {
    if (find(name, Slot::Kind::sampler)) this->texture(name, texture.name(), sampler(desc));
}

void Program::texture(std::string_view name, unsigned int texture, unsigned int sampler) const {
    const Slot* slot = find(name, Slot::Kind::sampler);
    if (!slot) return;
    glBindTextureUnit(static_cast<GLuint>(slot->unit), texture);
    glBindSampler(static_cast<GLuint>(slot->unit), sampler);
}

void Program::image(std::string_view name, const Texture& texture, int mip, bool write) const {
    if (const Slot* slot = find(name, Slot::Kind::image))
        glBindImageTexture(static_cast<GLuint>(slot->unit), texture.name(), mip, GL_TRUE, 0,
                           write ? GL_READ_WRITE : GL_READ_ONLY, info(texture.desc().format).internal);
}

void Program::block(std::string_view name, const Buffer& buffer) const {
    block(name, buffer, 0, buffer.size());
}

void Program::block(std::string_view name, const Buffer& buffer, size_t offset, size_t bytes) const {
    for (const auto& [kind, target] : {std::pair{Slot::Kind::uniform_block, GL_UNIFORM_BUFFER},
                                       std::pair{Slot::Kind::storage_block, GL_SHADER_STORAGE_BUFFER}}) {
        const Slot* slot = find(name, kind);
        if (!slot) continue;
        const auto unit = static_cast<GLuint>(slot->unit);
        if (bytes == 0)
            glBindBufferBase(static_cast<GLenum>(target), unit, buffer.name());
        else
            glBindBufferRange(static_cast<GLenum>(target), unit, buffer.name(), static_cast<GLintptr>(offset),
                              static_cast<GLsizeiptr>(bytes));
    }
}

}  // namespace tyndall::gpu
