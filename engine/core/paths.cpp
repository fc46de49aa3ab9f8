#include "core/paths.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>
#include <vector>

#include "core/error.h"

namespace tyndall::paths {
namespace fs = std::filesystem;
namespace {

fs::path find_root() {
    if (const char* wanted = std::getenv("TYNDALL_ROOT")) return fs::weakly_canonical(wanted);
    std::error_code ignored;
    for (const fs::path& start : {fs::read_symlink("/proc/self/exe", ignored).parent_path(), fs::current_path()})
        for (fs::path folder = start; folder.has_relative_path(); folder = folder.parent_path())
            if (fs::is_directory(folder / "engine" / "core") && fs::is_directory(folder / "config")) return folder;
    throw Error("the project's folders engine/ and config/ were not found above the program; set TYNDALL_ROOT");
}

[[noreturn]] void fail(const fs::path& file, std::string_view what) {
    throw Error(Diagnostic{{file.string()}, std::string(what) + ": " + std::strerror(errno), {}, {}});
}

Error missing(const fs::path& base, std::string_view name) {
    std::vector<std::string> beside;
    std::error_code ignored;
    const fs::path folder = (base / name).parent_path();
    for (const auto& entry : fs::directory_iterator(folder, ignored))
        beside.push_back(entry.path().filename().string());
    const std::string near = nearest_name(fs::path(name).filename().string(), beside);
    return Error(Diagnostic{{(base / name).string()},
                            "no such file",
                            "a file below " + base.string(),
                            near.empty() ? near : (fs::path(name).parent_path() / near).string()});
}

}  // namespace

const fs::path& root() {
    static const fs::path found = find_root();
    return found;
}

fs::path build() {
    std::error_code ignored;
    return fs::read_symlink("/proc/self/exe", ignored).parent_path().parent_path();
}

fs::path resolve_asset(const fs::path& base, std::string_view name) {
    const fs::path relative(name);
    if (name.empty() || relative.is_absolute() || name.find('\\') != std::string_view::npos ||
        name.find('\0') != std::string_view::npos)
        throw Error(Diagnostic{
            {}, "asset name '" + std::string(name) + "' is not a relative path", "such as 'textures/stone.png'", {}});
    std::error_code failed;
    const fs::path folder = fs::weakly_canonical(base, failed);
    const fs::path full = fs::weakly_canonical(folder / relative, failed);
    const fs::path inside = full.lexically_relative(folder);
    if (failed || inside.empty() || *inside.begin() == "..")
        throw Error(Diagnostic{
            {}, "asset name '" + std::string(name) + "' leaves its folder", "a file below " + base.string(), {}});
    if (!fs::is_regular_file(full, failed)) throw missing(base, name);
    return full;
}

std::string read_file(const fs::path& file) {
    errno = 0;
    std::error_code ignored;
    if (fs::is_directory(file, ignored)) {
        errno = EISDIR;
        fail(file, "cannot read");
    }
    std::ifstream in(file, std::ios::binary);
    if (!in) fail(file, "cannot read");
    std::string content{std::istreambuf_iterator<char>(in), {}};
    if (in.bad()) fail(file, "cannot read");
    return content;
}

void write_file_atomically(const fs::path& file, std::string_view content) {
    std::string temporary = file.string() + ".XXXXXX";
    const int descriptor = mkstemp(temporary.data());
    if (descriptor < 0) fail(file, "cannot write beside");
    bool ok = fchmod(descriptor, 0644) == 0;
    for (size_t done = 0; ok && done < content.size();) {
        const ssize_t n = ::write(descriptor, content.data() + done, content.size() - done);
        if (n < 0 && errno == EINTR) continue;
        ok = n > 0;
        if (ok) done += static_cast<size_t>(n);
    }
    ok = fsync(descriptor) == 0 && ok;
    ok = close(descriptor) == 0 && ok;
    ok = ok && std::rename(temporary.c_str(), file.c_str()) == 0;
    if (!ok) {
        const int reason = errno;
        ::unlink(temporary.c_str());
        errno = reason;
        fail(file, "cannot write");
    }
}

}  // namespace tyndall::paths
