#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "render/graph_plan.h"

namespace tyndall {
namespace {

using Access = PassDeclaration::Access;

std::string target_line(const PlannedTarget& target, size_t texture, glm::ivec2 frame_size) {
    if (target.desc.own)
        return fmt::format("  \"t:{0}\" [shape=ellipse, label=\"{0}\\nthe pass's own\"];\n", target.name);
    const gpu::TextureDesc desc = texture_desc(target.desc, frame_size);
    std::string extent = fmt::format("{} x {}", desc.width, desc.height);
    if (desc.layers > 1) extent += fmt::format(" x {}", desc.layers);
    if (desc.mips > 1) extent += fmt::format(", {} mips", desc.mips);
    // Targets that share a texture share a colour.
    constexpr std::array<std::string_view, 8> kColours{"lightyellow", "lightblue", "lightpink", "palegreen",
                                                       "lightsalmon", "plum",      "lightcyan", "khaki"};
    const std::string_view colour = target.history ? "white" : kColours.at(texture % kColours.size());
    return fmt::format("  \"t:{0}\" [shape=ellipse, style=filled, fillcolor={1}, label=\"{0}\\n{2} {3}\\n{4}\"];\n",
                       target.name, colour, gpu::name_of(desc.format), extent,
                       target.history ? std::string("two textures, with history") : fmt::format("texture {}", texture));
}

std::string access_line(const std::string& pass, const Access& access) {
    switch (access.kind) {
        case Access::Kind::read:
            return fmt::format("  \"t:{}\" -> \"{}\"{};\n", access.target, pass,
                               access.previous ? " [style=dashed, label=\"previous\", constraint=false]" : "");
        case Access::Kind::write:
            return fmt::format("  \"{}\" -> \"t:{}\";\n", pass, access.target);
        case Access::Kind::update:
            return fmt::format("  \"{}\" -> \"t:{}\" [dir=both];\n", pass, access.target);
    }
    return {};
}

}  // namespace

std::string graph_text(std::span<const DeclaredPass> passes, const GraphPlan& plan, std::span<const size_t> textures,
                       glm::ivec2 frame_size) {
    std::string text = "digraph frame {\n  rankdir=LR;\n  node [fontname=\"sans-serif\"];\n";
    for (size_t i = 0; i < plan.order.size(); ++i) {
        const DeclaredPass& pass = passes[plan.order[i]];
        text += fmt::format("  \"{0}\" [shape=box, label=\"{1}. {0}\\n{2}\"];\n", pass.name, i + 1,
                            name_of(pass.declaration.stage_));
    }
    for (size_t i = 0; i < plan.targets.size(); ++i)
        if (plan.targets[i].first >= 0) text += target_line(plan.targets[i], textures[i], frame_size);
    const auto exists = [&](const std::string& name) {
        return std::ranges::any_of(plan.targets, [&](const PlannedTarget& target) { return target.name == name; });
    };
    for (const size_t pass : plan.order)
        for (const Access& access : passes[pass].declaration.accesses_)
            if (exists(access.target)) text += access_line(passes[pass].name, access);
    return text + "}\n";
}

}  // namespace tyndall
