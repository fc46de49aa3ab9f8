#pragma once
/// The part of the frame graph that needs no GL: from declarations to an order, lives of targets, shared textures.

#include <span>
#include <string>
#include <vector>

#include "render/frame_graph.h"

namespace tyndall {

/// A pass's name and what it declared.
struct DeclaredPass {
    std::string name;
    PassDeclaration declaration;
};

/// A target and the part of the frame in which its content matters.
struct PlannedTarget {
    std::string name;
    TargetDesc desc;
    size_t creator = 0;        ///< index into the declared passes
    int first = -1;            ///< its creator's place in the order; -1 = the creator was left out
    int last = -1;             ///< place of its last user
    bool whole_frame = false;  ///< shown or kept after the frame: lives to its end
    bool history = false;      ///< a pass reads the last frame's content: two textures that take turns
};

/// What runs, in which order, and how long each target lives.
struct GraphPlan {
    std::vector<size_t> order;           ///< indices into the declared passes; passes that nothing needs are left out
    std::vector<PlannedTarget> targets;  ///< all declared ones, in order of declaration
};

/// Orders the passes: creator, updaters by stage, readers; among passes that are ready the lowest stage first, then
/// the order of `passes`. Needed are passes with keep(), creators and updaters of "display" and of `retained` targets
/// (unknown names there are ignored), and all that those read. Throws Error with everything that is wrong.
[[nodiscard]] GraphPlan plan_graph(std::span<const DeclaredPass> passes, std::span<const std::string> retained);

/// Where and how long a texture is used: places in the order, both included.
struct Lifetime {
    gpu::TextureDesc desc;
    int first = 0;
    int last = 0;
};

/// A texture number for each lifetime: equal numbers have equal descriptions and never live at the same time.
[[nodiscard]] std::vector<size_t> share_textures(std::span<const Lifetime> lifetimes);

/// The texture of a target in a frame of this size.
[[nodiscard]] gpu::TextureDesc texture_desc(const TargetDesc& desc, glm::ivec2 frame_size);
/// Bytes of all mips and layers.
[[nodiscard]] size_t texture_bytes(const gpu::TextureDesc& desc);

/// Graphviz text of a plan: passes by stage, targets with size and texture.
[[nodiscard]] std::string graph_text(std::span<const DeclaredPass> passes, const GraphPlan& plan,
                                     std::span<const size_t> textures, glm::ivec2 frame_size);

}  // namespace tyndall
