#include "core/log.h"

#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/spdlog.h>

#include <cstdlib>
#include <mutex>

namespace tyndall::log {
namespace {

struct State {
    std::shared_ptr<spdlog::logger> logger;
    std::function<void(Level, std::string_view)> sink;
    std::mutex mutex;

    State() : logger(std::make_shared<spdlog::logger>("", std::make_shared<spdlog::sinks::stderr_color_sink_mt>())) {
        logger->set_pattern("%^%l%$ %v");
        const char* wanted = std::getenv("TYNDALL_LOG");
        logger->set_level(wanted ? spdlog::level::from_str(wanted) : spdlog::level::info);
    }
};

State& state() {
    static State instance;
    return instance;
}

spdlog::level::level_enum translate(Level level) {
    switch (level) {
        case Level::debug:
            return spdlog::level::debug;
        case Level::info:
            return spdlog::level::info;
        case Level::warning:
            return spdlog::level::warn;
        case Level::error:
            return spdlog::level::err;
    }
    return spdlog::level::err;
}

}  // namespace

void set_level(Level level) {
    state().logger->set_level(translate(level));
}

void set_sink(std::function<void(Level, std::string_view)> sink) {
    const std::lock_guard lock(state().mutex);
    state().sink = std::move(sink);
}

void write(Level level, std::string_view message) {
    State& s = state();
    if (!s.logger->should_log(translate(level))) return;
    s.logger->log(translate(level), message);
    const std::lock_guard lock(s.mutex);
    if (s.sink) s.sink(level, message);
}

}  // namespace tyndall::log
