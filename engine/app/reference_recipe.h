#pragma once
/// What a traced reference is made from, and telling whether a stored one still is.

#include <glm/vec2.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "app/capture_file.h"

namespace tyndall {

/// A fingerprint of text or of a file's content, sixteen hexadecimal digits (FNV-1a).
[[nodiscard]] std::string content_hash(std::string_view content);

/// What a reference is to be made from, as JSON: the scene with its changes, but not how it is rendered ("render" but
/// for the camera, "description"); the content of the files that it names; camera, size, and what is traced. Spaces
/// and the order of keys do not matter. Throws Error for a scene that cannot be read.
[[nodiscard]] std::string recipe_of(const CaptureFile& capture, const TracedReference& reference);

/// The changes of the scene that is traced, in order, as `--set`.
[[nodiscard]] std::vector<std::string> changes_of(const CaptureFile& capture, const TracedReference& reference);
/// Width and height of a reference.
[[nodiscard]] glm::ivec2 size_of(const CaptureFile& capture, const TracedReference& reference);

/// Empty when the recipe that a stored reference carries is the wanted one; otherwise what is different, for people.
[[nodiscard]] std::string difference_of_recipes(const std::string& stored, const std::string& wanted);

}  // namespace tyndall
