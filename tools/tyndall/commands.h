#pragma once
/// The program's commands. Each adds itself to the command line and says what to run when it is chosen.

#include <CLI/CLI.hpp>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "app/engine.h"

namespace tyndall {

/// What the chosen command does; returns the program's exit code. May throw Error.
using Command = std::function<int()>;

void add_play(CLI::App& app, Command& command);
void add_capture(CLI::App& app, Command& command);
void add_bench(CLI::App& app, Command& command);
void add_trace(CLI::App& app, Command& command);
void add_merge(CLI::App& app, Command& command);
void add_compare(CLI::App& app, Command& command);
void add_measure(CLI::App& app, Command& command);
void add_schema(CLI::App& app, Command& command);
void add_validate(CLI::App& app, Command& command);
void add_modules(CLI::App& app, Command& command);
void add_mie(CLI::App& app, Command& command);
void add_profile(CLI::App& app, Command& command);
void add_farm(CLI::App& app, Command& command);
void add_info(CLI::App& app, Command& command);

/// "1280x720". Throws Error.
[[nodiscard]] glm::ivec2 parse_size(const std::string& text);

/// Options that play, capture and bench share.
struct SceneOptions {
    std::vector<std::string> set;
    std::string ocio, path, camera, view;

    void add_to(CLI::App& command);
    /// Without what only rendering has: render path and targets.
    void add_scene_to(CLI::App& command);
    /// `set` and `path` as changes of the scene file.
    [[nodiscard]] Assignments changes() const;
};

}  // namespace tyndall
