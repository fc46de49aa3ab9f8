#pragma once
/// The names of a graph: which pass makes, changes and reads which target, and what is wrong with that.

#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "render/graph_plan.h"

namespace tyndall {

/// A target and its passes, as indices into the declared passes in order of declaration.
struct TargetUsers {
    std::string name;
    TargetDesc desc;
    size_t creator = 0;
    std::vector<size_t> updaters;
    std::vector<size_t> readers;           ///< without updaters
    std::vector<size_t> previous_readers;  ///< of the last frame's content
};

/// Names resolved to indices.
struct GraphNames {
    std::vector<TargetUsers> targets;
    std::unordered_map<std::string_view, size_t> target_index;
    std::unordered_map<std::string_view, size_t> pass_index;
};

/// Throws Error with every name that is taken twice, missing or misused. The result refers to texts in `passes`.
[[nodiscard]] GraphNames resolve_names(std::span<const DeclaredPass> passes);

}  // namespace tyndall
