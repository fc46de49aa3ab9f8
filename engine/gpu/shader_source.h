#pragma once
/// Shader texts before the driver sees them: where they lie, what they include, what the driver's messages mean.
/// No GL here; for this floor's sources and tests.

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.h"

namespace tyndall::gpu {

/// A text that a program was made from, as it was when read; `file` is empty for generated texts.
struct ShaderText {
    std::filesystem::path file;
    std::filesystem::file_time_type modified;  ///< min() when the file was missing
    std::string text;
};

/// Serves shader texts by name: generated ones first, then the folder whose prefix the name begins with, then the
/// engine's own folder.
class ShaderFiles {
 public:
    explicit ShaderFiles(std::filesystem::path engine) : engine_(std::move(engine)) {}

    void add_folder(const std::string& prefix, const std::filesystem::path& folder) { folders_[prefix] = folder; }
    void remove_folder(const std::string& prefix) { folders_.erase(prefix); }
    /// Returns whether the text is new or another than before.
    bool set_text(const std::string& name, std::string text);

    /// Throws Error, located at `from`, when there is no such text, naming the nearest that exists.
    [[nodiscard]] ShaderText find(const std::string& name, const SourceLocation& from) const;
    /// The file that would serve `name`, whether it exists or not; empty for generated texts.
    [[nodiscard]] std::filesystem::path file_of(const std::string& name) const;

 private:
    [[nodiscard]] std::vector<std::string> all_names() const;
    std::filesystem::path engine_;
    std::map<std::string, std::filesystem::path> folders_;
    std::map<std::string, std::string> generated_;
};

/// When the file was last written; min() when it cannot be asked.
[[nodiscard]] std::filesystem::file_time_type modified_time(const std::filesystem::path& file);

/// The texts that a program read, by name; kept to notice changes.
using ShaderReads = std::map<std::string, ShaderText>;

/// One stage, ready for the driver. Its lines are counted here rather than by `#line`: some compilers forget the source
/// number of some messages.
struct StageText {
    /// Where a line came from.
    struct Line {
        size_t source = 0;  ///< index into `sources`
        int number = 0;     ///< 1-based
    };
    std::string text;
    std::vector<std::string> sources;  ///< file, or name of a generated text; the first is the front matter
    std::vector<Line> lines;           ///< of `text`, in order
};

/// Front matter, defines, then the text `name` with its includes, each once. Adds what it reads (or misses) to `reads`.
[[nodiscard]] StageText assemble(const ShaderFiles& files, const std::string& name,
                                 const std::vector<std::string>& defines, ShaderReads& reads);

/// The errors of a driver's log, placed in the files that they are about. Understands the forms of Mesa, NVIDIA and
/// AMD.
[[nodiscard]] std::vector<Diagnostic> translate_log(std::string_view log, const StageText& stage);

}  // namespace tyndall::gpu
