#include "image/isolated.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <new>
#include <system_error>

#include "core/error.h"

namespace tyndall {
namespace {

// What a process may take: the largest volume, and what a file of its size unfolds to at most.
constexpr rlim_t kMemory = rlim_t{5} << 28;
constexpr rlim_t kMemoryPerByte = 64;
constexpr rlim_t kSeconds = 300;
constexpr int kDone = 0, kFailed = 1;  // exit codes; anything else is a crash

[[noreturn]] void fail(const std::filesystem::path& file, std::string message) {
    throw Error(Diagnostic{{file.string()}, std::move(message), {}, {}});
}

[[noreturn]] void fail_system(const std::filesystem::path& file, const char* step) {
    fail(file, std::string("cannot be read: ") + step + ": " + std::generic_category().message(errno));
}

/// Memory that both processes see.
struct SharedFile {
    int handle;
    explicit SharedFile(const std::filesystem::path& file) : handle(memfd_create("tyndall", MFD_CLOEXEC)) {
        if (handle < 0) fail_system(file, "memfd_create");
    }
    ~SharedFile() { close(handle); }
    SharedFile(const SharedFile&) = delete;
    SharedFile& operator=(const SharedFile&) = delete;

    [[nodiscard]] bool write(std::string_view bytes) const {
        for (ssize_t written = 0; !bytes.empty(); bytes.remove_prefix(static_cast<size_t>(written)))
            if ((written = ::write(handle, bytes.data(), bytes.size())) < 0) return false;
        return true;
    }
    /// What was written; empty when it cannot be read.
    [[nodiscard]] std::string read() const {
        struct stat status {};
        if (fstat(handle, &status) != 0) return {};
        std::string bytes(static_cast<size_t>(status.st_size), '\0');
        for (size_t at = 0; at < bytes.size();) {
            const ssize_t got = pread(handle, &bytes[at], bytes.size() - at, static_cast<off_t>(at));
            if (got <= 0) return {};
            at += static_cast<size_t>(got);
        }
        return bytes;
    }
};

void limit(int resource, rlim_t most) {
    const rlimit value{most, most};
    setrlimit(static_cast<__rlimit_resource>(resource), &value);
}

/// Bounds what the process may take, and silences the last words of libraries that crash.
void confine([[maybe_unused]] const std::filesystem::path& file) {
    limit(RLIMIT_CORE, 0);
    limit(RLIMIT_CPU, kSeconds);
    alarm(kSeconds);                                                 // one that waits for ever takes no processor time
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)  // which reserve terabytes
    std::error_code unknown;
    const uintmax_t size = std::filesystem::file_size(file, unknown);
    rlim_t pages = 0;
    if (std::ifstream("/proc/self/statm") >> pages)
        limit(RLIMIT_AS,
              pages * static_cast<rlim_t>(sysconf(_SC_PAGESIZE)) + kMemory + kMemoryPerByte * (unknown ? 0 : size));
#endif
    const int nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC);
    if (nowhere >= 0) dup2(nowhere, STDERR_FILENO);
}

/// The child's whole life: bytes, or the parts of a Diagnostic.
int work_and_write(const SharedFile& shared, const std::filesystem::path& file, FunctionRef<std::string()> work) {
    try {
        confine(file);
        return shared.write(work()) ? kDone : kFailed + 1;
    } catch (const Error& error) {
        const Diagnostic& first = error.diagnostics().front();
        const char end = '\0';
        return shared.write(first.message + end + first.expected + end + first.suggestion) ? kFailed : kFailed + 1;
    } catch (const std::bad_alloc&) {
        return shared.write("it does not fit into memory, or is corrupt") ? kFailed : kFailed + 1;
    } catch (const std::exception& error) {
        return shared.write(std::string("cannot be read: ") + error.what()) ? kFailed : kFailed + 1;
    }
}

int wait_for(pid_t child, const std::filesystem::path& file) {
    int status = 0;
    while (waitpid(child, &status, 0) < 0)
        if (errno != EINTR) fail_system(file, "waitpid");
    return status;
}

}  // namespace

std::string run_isolated(const std::filesystem::path& file, FunctionRef<std::string()> work) {
    const SharedFile shared(file);
    const pid_t child = fork();
    if (child < 0) fail_system(file, "fork");
    if (child == 0) _exit(work_and_write(shared, file, work));
    const int status = wait_for(child, file);
    if (!WIFEXITED(status) || (WEXITSTATUS(status) != kDone && WEXITSTATUS(status) != kFailed))
        fail(file, "the file is corrupt: its reader crashed, or took too much memory or time");
    std::string bytes = shared.read();
    if (WEXITSTATUS(status) == kDone) return bytes;
    const size_t message = std::min(bytes.find('\0'), bytes.size());
    const size_t expected = std::min(bytes.find('\0', message + 1), bytes.size());
    const auto part = [&](size_t from, size_t to) { return from < to ? bytes.substr(from, to - from) : std::string(); };
    throw Error(
        Diagnostic{{file.string()}, part(0, message), part(message + 1, expected), part(expected + 1, bytes.size())});
}

}  // namespace tyndall
