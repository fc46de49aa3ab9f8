#pragma once
/// Telling whether a stored reference is still the one that a capture asks for.

#include <string>

namespace tyndall {

/// Empty when the recipe that a stored reference carries is the wanted one; otherwise what is different, for people.
[[nodiscard]] std::string difference_of_recipes(const std::string& stored, const std::string& wanted);

}  // namespace tyndall
