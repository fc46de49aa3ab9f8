#pragma once
/// Running a library that a broken file can make crash, hang or eat memory, where that does no harm.

#include <filesystem>
#include <string>

#include "core/function_ref.h"

namespace tyndall {

/// Calls `work` in a forked process of its own, with `file` for error messages, and returns the bytes that it returns.
/// The process has little more than a gigabyte of memory, more for a large
/// file, and minutes of processor time. Throws the Error that `work` throws, and an
/// Error that names `file` where the process ends in any other way. `work` must not use other threads, which a forked
/// process does not have, and what it changes in memory is lost.
[[nodiscard]] std::string run_isolated(const std::filesystem::path& file, FunctionRef<std::string()> work);

}  // namespace tyndall
