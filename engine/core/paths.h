#pragma once
/// Where things lie, and reading and writing files so that a user's work is never lost.

#include <filesystem>
#include <string>
#include <string_view>

namespace tyndall::paths {

/// The project's root: TYNDALL_ROOT, or the nearest folder above the program that holds engine/ and config/.
/// Throws Error when there is none.
[[nodiscard]] const std::filesystem::path& root();
/// The folder of the running program's build ("build/release"), where modules/ lies.
[[nodiscard]] std::filesystem::path build();

/// Resolves an asset name from a user's file: relative, forward slashes, inside `base` after symbolic links are
/// followed. Throws Error for an absolute name, one that leaves `base`, or a file that does not exist (with the nearest
/// file name).
[[nodiscard]] std::filesystem::path resolve_asset(const std::filesystem::path& base, std::string_view name);

/// The whole file. Throws Error naming the file and the system's reason.
[[nodiscard]] std::string read_file(const std::filesystem::path& file);
/// Writes to a temporary beside `file`, syncs, and renames: a crash leaves the old or the new file, whole.
void write_file_atomically(const std::filesystem::path& file, std::string_view content);

}  // namespace tyndall::paths
