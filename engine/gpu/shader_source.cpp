#include "gpu/shader_source.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <system_error>

#include "core/paths.h"

namespace tyndall::gpu {
namespace fs = std::filesystem;
namespace {

bool is_shader_file(const fs::path& file) {
    constexpr std::array<std::string_view, 5> kKinds{".glsl", ".vert", ".geom", ".frag", ".comp"};
    return std::ranges::find(kKinds, file.extension().string()) != kKinds.end();
}

void list_shaders(const fs::path& folder, const std::string& prefix, std::vector<std::string>& names) {
    std::error_code ignored;
    for (const auto& entry : fs::recursive_directory_iterator(folder, ignored))
        if (is_shader_file(entry.path())) names.push_back(prefix + entry.path().lexically_relative(folder).string());
}

std::string_view trimmed(std::string_view text) {
    const size_t first = text.find_first_not_of(" \t\r");
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

/// The directive's argument when the line is `#directive ...`, with blanks allowed around '#'.
bool is_directive(std::string_view line, std::string_view directive, std::string_view& argument) {
    line = trimmed(line);
    if (!line.starts_with('#')) return false;
    line = trimmed(line.substr(1));
    if (!line.starts_with(directive)) return false;
    argument = trimmed(line.substr(directive.size()));
    return true;
}

/// Builds one stage, text by text.
class Assembler {
 public:
    Assembler(const ShaderFiles& files, ShaderReads& reads) : files_(files), reads_(reads) {}

    void front(const std::vector<std::string>& defines) {
        out_.sources.emplace_back("the library's front matter");
        int number = 0;
        for (const std::string_view line :
             {"#version 450 core", "#define FN", "#define OUT(T) out T", "#define INOUT(T) inout T"})
            put(line, {0, ++number});
        for (const std::string& define : defines) put("#define " + define, {0, ++number});
    }

    void add(const std::string& name, const SourceLocation& from) {
        const auto known = reads_.find(name);
        if (known == reads_.end() || known->second.modified == fs::file_time_type::min()) read(name, from);
        const ShaderText& source = reads_.at(name);
        included_.push_back(name);
        const size_t index = out_.sources.size();
        out_.sources.push_back(source.file.empty() ? name : source.file.string());
        add_lines(source.text, index);
    }

    StageText take() { return std::move(out_); }

 private:
    /// A missing text is recorded too, so that the program is tried again once it is there.
    void read(const std::string& name, const SourceLocation& from) {
        reads_[name] = {files_.file_of(name), fs::file_time_type::min(), {}};
        reads_[name] = files_.find(name, from);
    }

    void add_lines(std::string_view text, size_t index) {
        int line_number = 0;
        while (!text.empty()) {
            const size_t end = std::min(text.find('\n'), text.size());
            const std::string_view line = text.substr(0, end);
            text.remove_prefix(std::min(end + 1, text.size()));
            ++line_number;
            const SourceLocation here{out_.sources[index], line_number};
            std::string_view argument;
            if (is_directive(line, "version", argument))
                throw Error(Diagnostic{here, "#version comes from the library", "no #version in shader files", {}});
            if (is_directive(line, "include", argument)) {
                include(argument, here);
                continue;
            }
            put(line, {index, line_number});
        }
    }

    void put(std::string_view line, StageText::Line from) {
        out_.text += line;
        out_.text += '\n';
        out_.lines.push_back(from);
    }

    void include(std::string_view argument, const SourceLocation& here) {
        const size_t end = argument.find('"', 1);
        if (!argument.starts_with('"') || end == std::string_view::npos || end < 2)
            throw Error(Diagnostic{here, "#include without a quoted name", "#include \"physics/phase.glsl\"", {}});
        const std::string name(argument.substr(1, end - 1));
        if (std::ranges::find(included_, name) == included_.end()) add(name, here);
    }

    const ShaderFiles& files_;
    ShaderReads& reads_;
    StageText out_;
    std::vector<std::string> included_;
};

}  // namespace

fs::file_time_type modified_time(const fs::path& file) {
    std::error_code failed;
    const auto time = fs::last_write_time(file, failed);
    return failed ? fs::file_time_type::min() : time;
}

bool ShaderFiles::set_text(const std::string& name, std::string text) {
    const auto [known, is_new] = generated_.try_emplace(name);
    if (!is_new && known->second == text) return false;
    known->second = std::move(text);
    return true;
}

fs::path ShaderFiles::file_of(const std::string& name) const {
    if (generated_.contains(name)) return {};
    for (auto folder = folders_.rbegin(); folder != folders_.rend(); ++folder)  // the longer of nested prefixes first
        if (name.starts_with(folder->first + "/")) return folder->second / name.substr(folder->first.size() + 1);
    return engine_ / name;
}

std::vector<std::string> ShaderFiles::all_names() const {
    std::vector<std::string> names;
    for (const auto& [name, text] : generated_) names.push_back(name);
    for (const auto& [prefix, folder] : folders_) list_shaders(folder, prefix + "/", names);
    list_shaders(engine_, "", names);
    return names;
}

ShaderText ShaderFiles::find(const std::string& name, const SourceLocation& from) const {
    const auto generated = generated_.find(name);
    if (generated != generated_.end()) return {{}, fs::file_time_type::max(), generated->second};
    const fs::path file = file_of(name);
    const fs::path plain = fs::path(name).lexically_normal();
    std::error_code ignored;
    if (plain.is_absolute() || *plain.begin() == ".." || !fs::is_regular_file(file, ignored))
        throw Error(Diagnostic{from, "there is no shader text '" + name + "'",
                               "a file of " + engine_.string() + " or of a module, or a generated text",
                               nearest_name(name, all_names())});
    // The time is taken first: a write in between is noticed by the next look.
    const auto modified = modified_time(file);
    return {file, modified, paths::read_file(file)};
}

StageText assemble(const ShaderFiles& files, const std::string& name, const std::vector<std::string>& defines,
                   ShaderReads& reads) {
    Assembler assembler(files, reads);
    assembler.front(defines);
    assembler.add(name, {});
    return assembler.take();
}

std::vector<Diagnostic> translate_log(std::string_view log, const StageText& stage) {
    std::vector<Diagnostic> out;
    while (!log.empty()) {
        const size_t end = std::min(log.find('\n'), log.size());
        const std::string line(trimmed(log.substr(0, end)));
        log.remove_prefix(std::min(end + 1, log.size()));
        if (line.empty() || line.find("warning") != std::string::npos) continue;
        int source = -1;
        int row = 0;
        int column = 0;
        int used = 0;
        const bool placed = (std::sscanf(line.c_str(), "%d:%d(%d): %n", &source, &row, &column, &used) == 3 && used) ||
                            (std::sscanf(line.c_str(), "%d(%d) : %n", &source, &row, &used) == 2 && used) ||
                            (std::sscanf(line.c_str(), "ERROR: %d:%d: %n", &source, &row, &used) == 2 && used);
        Diagnostic diagnostic{{}, placed ? line.substr(static_cast<size_t>(used)) : line, {}, {}};
        if (placed && row > 0 && static_cast<size_t>(row) <= stage.lines.size()) {
            const StageText::Line from = stage.lines[static_cast<size_t>(row) - 1];
            diagnostic.where = {stage.sources[from.source], from.number, column};
        }
        out.push_back(std::move(diagnostic));
    }
    return out;
}

}  // namespace tyndall::gpu
