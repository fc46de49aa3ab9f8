#pragma once
/// What tells one traced picture from another.

#include <string>

#include "app/engine.h"
#include "reference/trace.h"

namespace tyndall {

/// The scene's text with its changes, the content of its assets and of the OpenColorIO configuration, the camera and
/// the settings, as JSON: films with the same recipe can be added, and a cached reference with the same recipe is still
/// right. The engine has extracted the scene, and loaded no other before it, whose assets would count as well.
[[nodiscard]] std::string trace_recipe(const Engine& engine, const std::string& camera,
                                       const reference::TraceSettings& settings);

}  // namespace tyndall
