#pragma once
/// What the log says while a run is rendered in another way than the study asks for.

#include <string>
#include <string_view>

#include "core/log.h"

namespace tyndall {

/// Listens to the log, whose only sink it is while it lives, for a text; does nothing when that is empty.
class Refusal {
 public:
    explicit Refusal(std::string text) : text_(std::move(text)) {
        if (text_.empty()) return;
        log::set_level(log::Level::info);
        log::set_sink([this](log::Level, std::string_view message) {
            const size_t at = message.find(text_);
            if (at != std::string_view::npos && reason_.empty()) reason_ = message.substr(0, at);
        });
    }
    ~Refusal() {
        if (!text_.empty()) log::set_sink({});
    }
    Refusal(const Refusal&) = delete;
    Refusal& operator=(const Refusal&) = delete;

    /// What stands before the text in its line; empty = nothing was said.
    [[nodiscard]] const std::string& reason() const { return reason_; }

 private:
    std::string text_, reason_;
};

}  // namespace tyndall
