#pragma once
/// A pass that may fail without taking the frame with it.

#include <exception>
#include <string>
#include <utility>

#include "core/log.h"
#include "render/frame_graph.h"

namespace tyndall {

/// Runs another pass; what it throws is logged once and kept, and its targets stay as they were cleared.
class GuardedPass final : public Pass {
 public:
    explicit GuardedPass(Pass& pass) : pass_(pass) {}
    [[nodiscard]] std::string_view name() const override { return pass_.name(); }
    void declare(PassDeclaration& declaration) override { pass_.declare(declaration); }
    void execute(PassContext& context) override {
        try {
            pass_.execute(context);
            problem_.clear();
        } catch (const std::exception& error) {
            std::string text = "pass '" + std::string(pass_.name()) + "': " + error.what();
            if (text != problem_) log::error("{}", text);
            problem_ = std::move(text);
        }
    }
    /// What the last run threw; empty when all is well.
    [[nodiscard]] const std::string& problem() const { return problem_; }

 private:
    Pass& pass_;
    std::string problem_;
};

}  // namespace tyndall
