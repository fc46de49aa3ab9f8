#pragma once
/// What holds of every scene file, whatever components there are: versions, keys, names and parents.

#include <string>
#include <vector>

#include "scene/problems.h"

namespace tyndall {

/// The top-level "render" keys that are the engine's own.
inline constexpr std::string_view kRenderKeys[] = {"path", "display", "view", "camera"};
/// The keys of an entity that are no components.
inline constexpr std::string_view kEntityKeys[] = {"name", "parent"};

/// Checks a scene's structure: duplicate keys anywhere, unknown top-level keys, kinds, parents that exist, are unique
/// and make no cycle.
void check_structure(Problems& problems);

/// The items of "entities"; empty when there is none.
[[nodiscard]] const std::vector<JsonValue>& entity_values(const JsonDocument& document);
/// The text of a member that is a string, or empty.
[[nodiscard]] std::string text_member(const JsonValue& object, std::string_view key);

}  // namespace tyndall
