#pragma once
/// Other programs, started without a shell: arguments arrive as they are, whatever they hold.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace tyndall {

/// How a program ended.
struct ProcessEnd {
    int code = 0;    ///< its exit code; 128 + signal when a signal ended it
    int signal = 0;  ///< the signal that ended it; 0 = none

    [[nodiscard]] bool well() const { return code == 0; }
};

/// A program that runs beside this one. Destroying it waits for its end.
class Process {
 public:
    /// Starts `command` (the program, found through PATH, and its arguments) with its output and errors in the file
    /// `log`, which is emptied first. Throws Error when it cannot be started.
    Process(const std::vector<std::string>& command, const std::filesystem::path& log);
    ~Process();
    Process(const Process&) = delete;
    Process& operator=(const Process&) = delete;

    /// How it ended; empty while it runs. Does not wait.
    [[nodiscard]] std::optional<ProcessEnd> poll();

 private:
    int id_ = 0;
    std::optional<ProcessEnd> end_;
};

/// What a program that ended said.
struct ProcessResult {
    ProcessEnd end;
    std::string output;  ///< of its standard output
    std::string errors;  ///< of its standard error
};

/// Runs `command` (the program, found through PATH, and its arguments) in `directory` (empty = this program's) with
/// nothing to read, and waits for its end. Throws Error when it cannot be started.
[[nodiscard]] ProcessResult run_process(const std::vector<std::string>& command,
                                        const std::filesystem::path& directory = {});

}  // namespace tyndall
