#pragma once
/// What tells one traced picture from another.

#include <string>

#include "app/engine.h"
#include "reference/trace.h"

namespace tyndall {

/// The scene's text with its changes, the camera and the settings, as JSON: films with the same recipe can be added,
/// and a cached reference with the same recipe is still right. Assets count by name only.
[[nodiscard]] std::string trace_recipe(Engine& engine, const std::string& camera,
                                       const reference::TraceSettings& settings);

}  // namespace tyndall
