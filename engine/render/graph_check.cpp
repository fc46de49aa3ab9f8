#include "render/graph_check.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.h"

namespace tyndall {
namespace {

using Access = PassDeclaration::Access;

/// Collects what is wrong while it resolves.
class Resolver {
 public:
    explicit Resolver(std::span<const DeclaredPass> passes) : passes_(passes) {
        // Names are referred to by views into `targets`: it must not move.
        size_t writes = 0;
        for (const DeclaredPass& pass : passes)
            for (const Access& access : pass.declaration.accesses_) writes += access.kind == Access::Kind::write;
        names_.targets.reserve(writes);
    }

    GraphNames run() {
        for (size_t i = 0; i < passes_.size(); ++i) add_pass(i);
        for (size_t i = 0; i < passes_.size(); ++i)
            for (const Access& access : passes_[i].declaration.accesses_)
                if (access.kind == Access::Kind::write) add_target(i, access);
        for (size_t i = 0; i < passes_.size(); ++i)
            for (const Access& access : passes_[i].declaration.accesses_)
                if (access.kind == Access::Kind::update) add_update(i, access);
        for (size_t i = 0; i < passes_.size(); ++i)
            for (const Access& access : passes_[i].declaration.accesses_)
                if (access.kind == Access::Kind::read) add_read(i, access);
        if (!wrong_.empty()) throw Error(std::move(wrong_)).within("frame graph");
        return std::move(names_);
    }

 private:
    void complain(std::string message, std::string expected = {}, std::string suggestion = {}) {
        wrong_.push_back({{}, std::move(message), std::move(expected), std::move(suggestion)});
    }

    void add_pass(size_t index) {
        const std::string& name = passes_[index].name;
        if (name.empty()) complain(fmt::format("pass number {} has no name", index));
        if (!names_.pass_index.emplace(name, index).second)
            complain(fmt::format("two passes are called '{}'", name), "unique names of passes");
    }

    void add_target(size_t pass, const Access& access) {
        const std::string& by = passes_[pass].name;
        const TargetDesc& desc = access.desc;
        if (access.target.empty() || access.target.find('@') != std::string::npos)
            complain(fmt::format("pass '{}' writes a target called '{}'", by, access.target), "a name without '@'");
        if (desc.layers < 1 || desc.mips < 0 || desc.size.x < 0 || desc.size.y < 0 ||
            (desc.size.x == 0 && !(desc.scale > 0.0f && desc.scale <= 8.0f)))
            complain(fmt::format("pass '{}' writes '{}' with {} layers, {} mips, size {} x {}, scale {}", by,
                                 access.target, desc.layers, desc.mips, desc.size.x, desc.size.y, desc.scale),
                     "at least one layer, a positive size, or a scale up to 8");
        if (desc.own && desc.history)
            complain(fmt::format("pass '{}' wants history of '{}', which is its own texture", by, access.target));
        const auto known = names_.target_index.find(access.target);
        if (known != names_.target_index.end()) {
            complain(fmt::format("passes '{}' and '{}' both create target '{}'",
                                 passes_[names_.targets[known->second].creator].name, by, access.target),
                     "one creator, and passes that update");
            return;
        }
        names_.targets.push_back({access.target, desc, pass, {}, {}, {}});
        names_.target_index.emplace(names_.targets.back().name, names_.targets.size() - 1);
    }

    /// Null after a complaint.
    TargetUsers* find(size_t pass, const Access& access, std::string_view verb) {
        const auto known = names_.target_index.find(access.target);
        if (known != names_.target_index.end()) return &names_.targets[known->second];
        if (access.optional) return nullptr;
        std::vector<std::string> candidates;
        for (const TargetUsers& target : names_.targets) candidates.push_back(target.name);
        complain(fmt::format("pass '{}' {} '{}', which no pass writes", passes_[pass].name, verb, access.target), {},
                 nearest_name(access.target, candidates));
        return nullptr;
    }

    void add_update(size_t pass, const Access& access) {
        TargetUsers* target = find(pass, access, "updates");
        if (target == nullptr) return;
        if (target->creator == pass)
            complain(fmt::format("pass '{}' both writes and updates '{}'", passes_[pass].name, access.target));
        else if (std::ranges::find(target->updaters, pass) == target->updaters.end())
            target->updaters.push_back(pass);
    }

    void add_read(size_t pass, const Access& access) {
        TargetUsers* target = find(pass, access, access.previous ? "reads the last frame's" : "reads");
        if (target == nullptr) return;
        if (access.previous) {
            if (target->desc.history)
                target->previous_readers.push_back(pass);
            else if (!access.optional)
                complain(fmt::format("pass '{}' reads '{}@previous', but '{}' writes that target without history",
                                     passes_[pass].name, access.target, passes_[target->creator].name));
        } else if (target->creator == pass) {
            complain(fmt::format("pass '{}' reads '{}', which it writes itself", passes_[pass].name, access.target));
        } else if (std::ranges::find(target->updaters, pass) == target->updaters.end()) {
            target->readers.push_back(pass);
        }
    }

    std::span<const DeclaredPass> passes_;
    GraphNames names_;
    std::vector<Diagnostic> wrong_;
};

}  // namespace

GraphNames resolve_names(std::span<const DeclaredPass> passes) {
    return Resolver(passes).run();
}

}  // namespace tyndall
