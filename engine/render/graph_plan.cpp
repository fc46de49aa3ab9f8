#include "render/graph_plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <queue>

#include "core/error.h"
#include "render/graph_check.h"

namespace tyndall {
namespace {

/// `to` runs after `from`.
struct Edge {
    size_t to = 0;
    std::string_view why;  ///< the target, or "after"
};
using Edges = std::vector<std::vector<Edge>>;

Stage stage_of(std::span<const DeclaredPass> passes, size_t pass) {
    return passes[pass].declaration.stage_;
}

Edges find_edges(std::span<const DeclaredPass> passes, const GraphNames& names) {
    Edges edges(passes.size());
    for (const TargetUsers& target : names.targets) {
        for (const size_t updater : target.updaters) {
            edges[target.creator].push_back({updater, target.name});
            for (const size_t later : target.updaters)
                if (stage_of(passes, updater) < stage_of(passes, later)) edges[updater].push_back({later, target.name});
            for (const size_t reader : target.readers) edges[updater].push_back({reader, target.name});
        }
        for (const size_t reader : target.readers) edges[target.creator].push_back({reader, target.name});
    }
    for (size_t i = 0; i < passes.size(); ++i)
        for (const std::string& earlier : passes[i].declaration.after_) {
            // A pass that is not there has nothing to wait for: modules may name passes of other modules.
            const auto found = names.pass_index.find(earlier);
            if (found != names.pass_index.end()) edges[found->second].push_back({i, "after"});
        }
    return edges;
}

/// Names one cycle among the passes that could not be ordered.
[[noreturn]] void throw_cycle(std::span<const DeclaredPass> passes, const Edges& edges,
                              const std::vector<size_t>& open) {
    const auto stuck = [&](size_t pass) { return open[pass] > 0; };
    // Each stuck pass waits for a stuck pass: walking backwards must come round.
    std::vector<std::pair<size_t, std::string_view>> waits_for(passes.size());
    for (size_t from = 0; from < passes.size(); ++from)
        for (const Edge& edge : edges[from])
            if (stuck(from) && stuck(edge.to)) waits_for[edge.to] = {from, edge.why};
    size_t at = static_cast<size_t>(std::ranges::find_if(open, [](size_t n) { return n > 0; }) - open.begin());
    for (size_t i = 0; i < passes.size(); ++i) at = waits_for[at].first;
    std::string text;
    size_t walker = at;
    do {
        const auto [from, why] = waits_for[walker];
        text += fmt::format("'{}' waits for '{}' ({}), ", passes[walker].name, passes[from].name, why);
        walker = from;
    } while (walker != at);
    text.resize(text.size() - 2);
    throw Error("frame graph: passes wait for one another in a cycle: " + text);
}

std::vector<size_t> sort(std::span<const DeclaredPass> passes, const Edges& edges) {
    std::vector<size_t> open(passes.size(), 0);
    for (const auto& from : edges)
        for (const Edge& edge : from) ++open[edge.to];
    using Ready = std::pair<Stage, size_t>;
    std::priority_queue<Ready, std::vector<Ready>, std::greater<>> ready;
    for (size_t i = 0; i < passes.size(); ++i)
        if (open[i] == 0) ready.emplace(stage_of(passes, i), i);
    std::vector<size_t> order;
    while (!ready.empty()) {
        const size_t pass = ready.top().second;
        ready.pop();
        order.push_back(pass);
        for (const Edge& edge : edges[pass])
            if (--open[edge.to] == 0) ready.emplace(stage_of(passes, edge.to), edge.to);
    }
    if (order.size() < passes.size()) throw_cycle(passes, edges, open);
    return order;
}

/// after[i][j]: pass j runs after pass i for a reason, not by chance of registration.
std::vector<std::vector<bool>> find_successors(const Edges& edges, const std::vector<size_t>& order) {
    std::vector<std::vector<bool>> after(edges.size(), std::vector<bool>(edges.size(), false));
    for (auto pass = order.rbegin(); pass != order.rend(); ++pass)
        for (const Edge& edge : edges[*pass]) {
            after[*pass][edge.to] = true;
            for (size_t i = 0; i < edges.size(); ++i)
                if (after[edge.to][i]) after[*pass][i] = true;
        }
    return after;
}

/// "after" names of a pass that no pass has: a likely cause of missing order.
std::string unknown_after(std::span<const DeclaredPass> passes, const GraphNames& names, size_t pass) {
    std::vector<std::string> candidates;
    for (const DeclaredPass& known : passes) candidates.push_back(known.name);
    for (const std::string& earlier : passes[pass].declaration.after_)
        if (!names.pass_index.contains(earlier)) return nearest_name(earlier, candidates);
    return {};
}

void check_updaters(std::span<const DeclaredPass> passes, const GraphNames& names,
                    const std::vector<std::vector<bool>>& after) {
    std::vector<Diagnostic> wrong;
    for (const TargetUsers& target : names.targets)
        for (size_t i = 0; i < target.updaters.size(); ++i)
            for (size_t j = i + 1; j < target.updaters.size(); ++j) {
                const size_t a = target.updaters[i], b = target.updaters[j];
                if (after[a][b] || after[b][a]) continue;
                std::string near = unknown_after(passes, names, a);
                if (near.empty()) near = unknown_after(passes, names, b);
                wrong.push_back({{},
                                 fmt::format("passes '{}' and '{}' both update '{}' in stage {} without order",
                                             passes[a].name, passes[b].name, target.name, name_of(stage_of(passes, a))),
                                 "another stage, or after() in one of them",
                                 std::move(near)});
            }
    if (!wrong.empty()) throw Error(std::move(wrong)).within("frame graph");
}

/// Marks what is needed, from what is shown and kept back to what that depends on.
class Needs {
 public:
    Needs(std::span<const DeclaredPass> passes, const GraphNames& names)
        : passes_(passes), names_(names), pass_(passes.size(), false), target_(names.targets.size(), false) {}

    void target(size_t index) {
        if (target_[index]) return;
        target_[index] = true;
        pass(names_.targets[index].creator);
        for (const size_t updater : names_.targets[index].updaters) pass(updater);
    }

    void pass(size_t index) {
        if (pass_[index]) return;
        pass_[index] = true;
        for (const PassDeclaration::Access& access : passes_[index].declaration.accesses_) {
            if (access.kind == PassDeclaration::Access::Kind::write) continue;
            const auto found = names_.target_index.find(access.target);
            if (found != names_.target_index.end()) target(found->second);
        }
    }

    [[nodiscard]] bool has_pass(size_t index) const { return pass_[index]; }

 private:
    std::span<const DeclaredPass> passes_;
    const GraphNames& names_;
    std::vector<bool> pass_, target_;
};

PlannedTarget plan_target(const TargetUsers& users, const std::vector<int>& place, bool whole_frame, int end) {
    PlannedTarget planned{users.name, users.desc, users.creator, place[users.creator], place[users.creator]};
    for (const size_t updater : users.updaters) planned.last = std::max(planned.last, place[updater]);
    for (const size_t reader : users.readers) planned.last = std::max(planned.last, place[reader]);
    planned.history = planned.first >= 0 &&
                      std::ranges::any_of(users.previous_readers, [&](size_t reader) { return place[reader] >= 0; });
    planned.whole_frame = planned.first >= 0 && whole_frame;
    if (planned.whole_frame) planned.last = end;
    return planned;
}

}  // namespace

GraphPlan plan_graph(std::span<const DeclaredPass> passes, std::span<const std::string> retained) {
    const GraphNames names = resolve_names(passes);
    const Edges edges = find_edges(passes, names);
    const std::vector<size_t> sorted = sort(passes, edges);
    check_updaters(passes, names, find_successors(edges, sorted));

    const auto is_root = [&](const TargetUsers& target) {
        return target.name == "display" || std::ranges::find(retained, target.name) != retained.end();
    };
    Needs needs(passes, names);
    for (size_t i = 0; i < passes.size(); ++i)
        if (passes[i].declaration.keep_) needs.pass(i);
    for (size_t i = 0; i < names.targets.size(); ++i)
        if (is_root(names.targets[i])) needs.target(i);

    GraphPlan plan;
    std::vector<int> place(passes.size(), -1);
    for (const size_t pass : sorted) {
        if (!needs.has_pass(pass)) continue;
        place[pass] = static_cast<int>(plan.order.size());
        plan.order.push_back(pass);
    }
    const int end = static_cast<int>(plan.order.size());
    for (const TargetUsers& target : names.targets)
        plan.targets.push_back(plan_target(target, place, is_root(target), end));
    return plan;
}

std::vector<size_t> share_textures(std::span<const Lifetime> lifetimes) {
    std::vector<size_t> by_start(lifetimes.size());
    for (size_t i = 0; i < by_start.size(); ++i) by_start[i] = i;
    std::ranges::stable_sort(by_start, {}, [&](size_t i) { return lifetimes[i].first; });
    std::vector<Lifetime> textures;  // `last` is when the texture is free again
    std::vector<size_t> chosen(lifetimes.size());
    for (const size_t i : by_start) {
        const Lifetime& life = lifetimes[i];
        const auto free = std::ranges::find_if(
            textures, [&](const Lifetime& texture) { return texture.desc == life.desc && texture.last < life.first; });
        chosen[i] = static_cast<size_t>(free - textures.begin());
        if (free == textures.end())
            textures.push_back(life);
        else
            free->last = life.last;
    }
    return chosen;
}

gpu::TextureDesc texture_desc(const TargetDesc& desc, glm::ivec2 frame_size) {
    const auto scaled = [&](int extent) {
        return std::max(1, static_cast<int>(std::ceil(static_cast<float>(extent) * desc.scale)));
    };
    glm::ivec2 size = desc.size;
    if (size.x == 0) size = {scaled(frame_size.x), scaled(frame_size.y)};
    const bool volume = desc.shape == gpu::Shape::volume;
    int full = 1;
    for (int extent = std::max({size.x, size.y, volume ? desc.layers : 1}); extent > 1; extent /= 2) ++full;
    const int mips = desc.mips == 0 ? full : std::min(desc.mips, full);
    return {desc.shape, desc.format, size.x, std::max(1, size.y), desc.layers, mips};
}

size_t texture_bytes(const gpu::TextureDesc& desc) {
    size_t texels = 0;
    const bool volume = desc.shape == gpu::Shape::volume;
    const int faces = desc.shape == gpu::Shape::cube || desc.shape == gpu::Shape::cube_array ? 6 : 1;
    for (int mip = 0; mip < desc.mips; ++mip)
        texels += static_cast<size_t>(std::max(1, desc.width >> mip)) *
                  static_cast<size_t>(std::max(1, desc.height >> mip)) *
                  static_cast<size_t>(volume ? std::max(1, desc.layers >> mip) : desc.layers * faces);
    return texels * gpu::bytes_per_texel(desc.format);
}

}  // namespace tyndall
