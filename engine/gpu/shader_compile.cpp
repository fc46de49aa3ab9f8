#include "gpu/shader_compile.h"

#include <epoxy/gl.h>

#include "gpu/accounting.h"

namespace tyndall::gpu {
namespace {

/// A shader object for as long as it takes to link it.
struct Shader {
    explicit Shader(GLenum kind) : name(glCreateShader(kind)) {}
    ~Shader() { glDeleteShader(name); }
    Shader(const Shader&) = delete;
    Shader& operator=(const Shader&) = delete;
    GLuint name;
};

std::string shader_log(GLuint shader) {
    GLint length = 0;
    glGetShaderiv(shader, GL_INFO_LOG_LENGTH, &length);
    std::string log(static_cast<size_t>(length), '\0');
    if (length > 0) glGetShaderInfoLog(shader, length, &length, log.data());
    log.resize(static_cast<size_t>(length));
    return log;
}

std::string link_log(GLuint program) {
    GLint length = 0;
    glGetProgramiv(program, GL_INFO_LOG_LENGTH, &length);
    std::string log(static_cast<size_t>(length), '\0');
    if (length > 0) glGetProgramInfoLog(program, length, &length, log.data());
    log.resize(static_cast<size_t>(length));
    return log;
}

/// Compiles one stage into `program`; its errors go to `problems`.
void add_stage(GLuint program, GLenum kind, const StageText& stage, std::vector<Diagnostic>& problems) {
    const Shader shader(kind);
    const char* text = stage.text.c_str();
    const auto length = static_cast<GLint>(stage.text.size());
    glShaderSource(shader.name, 1, &text, &length);
    glCompileShader(shader.name);
    GLint compiled = GL_FALSE;
    glGetShaderiv(shader.name, GL_COMPILE_STATUS, &compiled);
    if (compiled == GL_TRUE) {
        glAttachShader(program, shader.name);  // keeps it alive until the program has linked
        return;
    }
    std::vector<Diagnostic> errors = translate_log(shader_log(shader.name), stage);
    if (errors.empty()) errors.push_back({{stage.sources.back()}, "the driver refuses it without a message", {}, {}});
    problems.insert(problems.end(), errors.begin(), errors.end());
}

void detach_stages(GLuint program) {
    GLuint shaders[5];
    GLsizei count = 0;
    glGetAttachedShaders(program, 5, &count, shaders);
    for (GLsizei i = 0; i < count; ++i) glDetachShader(program, shaders[i]);
}

/// A program object that is deleted unless it is handed on.
struct Linking {
    Linking() : name(glCreateProgram()) {}
    ~Linking() { glDeleteProgram(name); }
    Linking(const Linking&) = delete;
    Linking& operator=(const Linking&) = delete;
    GLuint take() { return std::exchange(name, 0); }
    GLuint name;
};

}  // namespace

Program compile(const ShaderFiles& files, const ProgramDesc& desc, ShaderReads& reads) {
    const bool drawn_full_screen = desc.vertex.empty() && !desc.fragment.empty();
    const std::pair<GLenum, std::string> stages[] = {
        {GL_VERTEX_SHADER, drawn_full_screen ? "gpu/shaders/fullscreen.vert" : desc.vertex},
        {GL_GEOMETRY_SHADER, desc.geometry},
        {GL_FRAGMENT_SHADER, desc.fragment},
        {GL_COMPUTE_SHADER, desc.compute}};
    Linking program;
    std::vector<Diagnostic> problems;
    for (const auto& [kind, name] : stages) {
        if (name.empty()) continue;
        try {
            add_stage(program.name, kind, assemble(files, name, desc.defines, reads), problems);
        } catch (const Error& error) {
            problems.insert(problems.end(), error.diagnostics().begin(), error.diagnostics().end());
        }
    }
    if (!problems.empty()) throw Error(std::move(problems)).within("building program '" + desc.name + "'");
    glLinkProgram(program.name);
    detach_stages(program.name);
    GLint linked = GL_FALSE;
    glGetProgramiv(program.name, GL_LINK_STATUS, &linked);
    if (linked != GL_TRUE) {
        problems = translate_log(link_log(program.name), {});
        if (problems.empty()) problems.push_back({{}, "the driver does not link it and gives no reason", {}, {}});
        throw Error(std::move(problems)).within("linking program '" + desc.name + "'");
    }
    set_label(GL_PROGRAM, program.name, desc.name);
    return Program(program.take());
}

}  // namespace tyndall::gpu
