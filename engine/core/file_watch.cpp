#include "core/file_watch.h"

#include <sys/stat.h>

#include <algorithm>
#include <system_error>

namespace tyndall {
namespace fs = std::filesystem;

FileWatch::State FileWatch::look_at(const fs::path& file) {
    struct stat found;
    if (::stat(file.c_str(), &found) != 0 || !S_ISREG(found.st_mode)) return {};
    return {found.st_mtim.tv_sec * int64_t{1'000'000'000} + found.st_mtim.tv_nsec, static_cast<uint64_t>(found.st_size),
            found.st_ino};
}

/// Enters files that are new in the folder, as not yet reported.
void FileWatch::scan(const fs::path& folder, Files& files) {
    std::error_code failed;  // a folder may vanish while it is read: what remains is found at the next look
    for (fs::recursive_directory_iterator at(folder, fs::directory_options::skip_permission_denied, failed), end;
         !failed && at != end; at.increment(failed)) {
        const std::string name = at->path().filename().string();
        std::error_code ignored;
        if (name.starts_with('.'))
            at.disable_recursion_pending();
        else if (!name.ends_with('~') && at->is_regular_file(ignored))
            files.try_emplace(at->path());
    }
}

void FileWatch::add(const fs::path& file_or_folder) {
    const auto know = [](Files::value_type& entry) {
        entry.second.reported = entry.second.seen = look_at(entry.first);
    };
    std::error_code ignored;
    if (!fs::is_directory(file_or_folder, ignored)) {
        if (const auto [entry, is_new] = files_.try_emplace(file_or_folder); is_new) know(*entry);
    } else if (const auto [entry, is_new] = by_folder_.try_emplace(file_or_folder); is_new) {
        scan(entry->first, entry->second);
        std::for_each(entry->second.begin(), entry->second.end(), know);
    }
}

void FileWatch::remove(const fs::path& file_or_folder) {
    files_.erase(file_or_folder);
    by_folder_.erase(file_or_folder);
}

std::vector<fs::path> FileWatch::changed(Clock::time_point now) {
    std::vector<fs::path> found;
    if (now < next_look_) return found;
    next_look_ = now + interval_;
    const auto look = [&](Files& files) {
        for (auto& [path, file] : files) {
            const State state = look_at(path);
            const bool settled = state == file.seen;
            file.seen = state;
            if (state == State{}) file.reported = {};
            if (!settled || state == file.reported) continue;
            file.reported = state;
            found.push_back(path);
        }
    };
    look(files_);
    for (auto& [folder, files] : by_folder_) {
        std::erase_if(files, [](const auto& entry) { return entry.second.seen == State{}; });
        scan(folder, files);
        look(files);
    }
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
}

}  // namespace tyndall
