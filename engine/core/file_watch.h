#pragma once
/// Noticing that files were saved.

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <map>
#include <vector>

namespace tyndall {

/// Watches files and folders by looking at them now and then: time of writing, size, inode.
///
/// A change is reported once the file has looked the same for one interval: an editor that empties a file and then
/// fills it, or writes beside it and renames over it, causes one report, of the finished file. A file that vanishes is
/// not reported; when it comes back it is.
class FileWatch {
 public:
    using Clock = std::chrono::steady_clock;

    /// `interval`: how often the files are looked at. A change is reported one to two intervals after it.
    explicit FileWatch(Clock::duration interval = std::chrono::milliseconds(100)) : interval_(interval) {}

    /// Watches a file, which need not exist yet, or everything in a folder and below, including files still to come.
    /// In folders, hidden files and those that end in '~' are ignored: they are an editor's own. As things are now
    /// counts as known.
    void add(const std::filesystem::path& file_or_folder);
    /// Stops watching what `add` was given.
    void remove(const std::filesystem::path& file_or_folder);

    /// The files that changed, came or came back since they were last reported, as `add` was given them (or below the
    /// folder it was given), each once, sorted. Cheap enough for every frame: between looks it does nothing.
    [[nodiscard]] std::vector<std::filesystem::path> changed(Clock::time_point now = Clock::now());

 private:
    /// What a file looks like from outside. All zero = not there.
    struct State {
        int64_t written_ns = 0;
        uint64_t size = 0;
        uint64_t inode = 0;
        bool operator==(const State&) const = default;
    };
    struct File {
        State reported;  ///< when it was last reported or added
        State seen;      ///< at the last look
    };
    using Files = std::map<std::filesystem::path, File>;

    static State look_at(const std::filesystem::path& file);
    static void scan(const std::filesystem::path& folder, Files& files);

    Clock::duration interval_;
    Clock::time_point next_look_{};
    Files files_;                                       ///< watched one by one
    std::map<std::filesystem::path, Files> by_folder_;  ///< what was found in each watched folder
};

}  // namespace tyndall
