#include "core/process.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "core/error.h"

extern char** environ;

namespace tyndall {
namespace fs = std::filesystem;
namespace {

/// What the new process does before the program begins.
class Actions {
 public:
    Actions() { posix_spawn_file_actions_init(&actions_); }
    ~Actions() { posix_spawn_file_actions_destroy(&actions_); }
    Actions(const Actions&) = delete;
    Actions& operator=(const Actions&) = delete;

    void open(int descriptor, const char* file, int flags) {
        posix_spawn_file_actions_addopen(&actions_, descriptor, file, flags, 0644);
    }
    void duplicate(int from, int to) { posix_spawn_file_actions_adddup2(&actions_, from, to); }
    void enter(const fs::path& folder) { posix_spawn_file_actions_addchdir_np(&actions_, folder.c_str()); }
    [[nodiscard]] const posix_spawn_file_actions_t* get() const { return &actions_; }

 private:
    posix_spawn_file_actions_t actions_;
};

/// A file without a name that takes what a program says: unlike a pipe it is never full.
class Spool {
 public:
    Spool() : descriptor_(memfd_create("spool", MFD_CLOEXEC)) {
        if (descriptor_ < 0) throw Error(std::string("no room for a program's output: ") + std::strerror(errno));
    }
    ~Spool() { close(descriptor_); }
    Spool(const Spool&) = delete;
    Spool& operator=(const Spool&) = delete;

    [[nodiscard]] int descriptor() const { return descriptor_; }
    [[nodiscard]] std::string content() const {
        std::string text;
        char block[4096];
        for (ssize_t n; (n = pread(descriptor_, block, sizeof block, static_cast<off_t>(text.size()))) > 0;)
            text.append(block, static_cast<size_t>(n));
        return text;
    }

 private:
    int descriptor_;
};

pid_t spawn(const std::vector<std::string>& command, const Actions& actions) {
    std::vector<char*> arguments;
    for (const std::string& argument : command) arguments.push_back(const_cast<char*>(argument.c_str()));
    arguments.push_back(nullptr);
    pid_t process = 0;
    const int failed = posix_spawnp(&process, arguments[0], actions.get(), nullptr, arguments.data(), environ);
    if (failed != 0) throw Error("'" + command[0] + "' could not be started: " + std::strerror(failed));
    return process;
}

ProcessEnd end_of(int status) {
    if (WIFSIGNALED(status)) return {128 + WTERMSIG(status), WTERMSIG(status)};
    return {WEXITSTATUS(status), 0};
}

/// Waits for a process; empty when `flags` say not to and it still runs.
std::optional<ProcessEnd> wait_for(pid_t process, int flags) {
    int status = 0;
    pid_t ended = 0;
    do ended = waitpid(process, &status, flags);
    while (ended < 0 && errno == EINTR);
    if (ended != process) return std::nullopt;
    return end_of(status);
}

}  // namespace

Process::Process(const std::vector<std::string>& command, const fs::path& log) {
    Actions actions;
    actions.open(STDOUT_FILENO, log.c_str(), O_WRONLY | O_CREAT | O_TRUNC);
    actions.duplicate(STDOUT_FILENO, STDERR_FILENO);
    id_ = spawn(command, actions);
}

Process::~Process() {
    if (!end_) (void)wait_for(id_, 0);
}

std::optional<ProcessEnd> Process::poll() {
    if (!end_) end_ = wait_for(id_, WNOHANG);
    return end_;
}

ProcessResult run_process(const std::vector<std::string>& command, const fs::path& directory) {
    const Spool output, errors;
    Actions actions;
    actions.open(STDIN_FILENO, "/dev/null", O_RDONLY);
    actions.duplicate(output.descriptor(), STDOUT_FILENO);
    actions.duplicate(errors.descriptor(), STDERR_FILENO);
    if (!directory.empty()) actions.enter(directory);
    const pid_t process = spawn(command, actions);
    ProcessResult result;
    result.end = wait_for(process, 0).value_or(ProcessEnd{127, 0});
    result.output = output.content();
    result.errors = errors.content();
    return result;
}

}  // namespace tyndall
