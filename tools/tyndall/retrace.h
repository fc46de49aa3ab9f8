#pragma once
/// Making a capture's traced references again.

#include <filesystem>
#include <string>

#include "app/capture_file.h"

namespace tyndall {

/// Traces references of a capture and stores them beside its file, each atomically: what was there stays until the new
/// one is whole. `which`: "changed" (those that are not there, broken, or of another recipe), "all", or a name.
/// Throws Error for an unknown name, a scene that cannot be traced, or a file that cannot be written.
void retrace(const CaptureFile& capture, const std::string& which, const std::filesystem::path& ocio);

}  // namespace tyndall
