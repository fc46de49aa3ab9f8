#pragma once
/// The log: the only global mutable state of the engine. Messages go to stderr and, when asked, to a sink of the
/// program's.

#include <fmt/format.h>

#include <functional>
#include <string_view>

namespace tyndall::log {

enum class Level { debug, info, warning, error };

/// Messages below this level are dropped. Default: info, or TYNDALL_LOG=debug|info|warning|error.
void set_level(Level level);
/// Receives every message that passes the level as well (the window's overlay, tests). Empty removes it.
void set_sink(std::function<void(Level, std::string_view)> sink);
void write(Level level, std::string_view message);

template <class... Args>
void debug(fmt::format_string<Args...> format, Args&&... args) {
    write(Level::debug, fmt::format(format, std::forward<Args>(args)...));
}
template <class... Args>
void info(fmt::format_string<Args...> format, Args&&... args) {
    write(Level::info, fmt::format(format, std::forward<Args>(args)...));
}
template <class... Args>
void warning(fmt::format_string<Args...> format, Args&&... args) {
    write(Level::warning, fmt::format(format, std::forward<Args>(args)...));
}
template <class... Args>
void error(fmt::format_string<Args...> format, Args&&... args) {
    write(Level::error, fmt::format(format, std::forward<Args>(args)...));
}

}  // namespace tyndall::log
