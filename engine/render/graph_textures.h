#pragma once
/// The textures behind a plan's targets.

#include <functional>
#include <string>
#include <vector>

#include "gpu/gpu.h"
#include "render/graph_plan.h"

namespace tyndall {

/// Owns transient textures, which targets share, and pairs of textures for history.
class GraphTextures {
 public:
    GraphTextures() = default;
    /// Takes over what fits from `old`: memory, and the history of targets whose description has not changed. Throws
    /// Error when a texture cannot be made.
    GraphTextures(const GraphPlan& plan, glm::ivec2 frame_size, GraphTextures& old);

    /// Null for targets of passes that were left out.
    [[nodiscard]] const gpu::Texture* current(size_t target) const;
    /// Last frame's content; null when there is none.
    [[nodiscard]] const gpu::Texture* previous(size_t target) const;
    /// True when no later target of the plan overwrote this one's texture.
    [[nodiscard]] bool survives(size_t target) const;
    /// Before a frame's passes: history targets take turns. `drop` = last frame's content is void.
    void next_frame(bool drop);

    /// Lets go of the textures that passes own.
    void forget_owned() { owned_.clear(); }

    /// For drawings: equal numbers share a texture.
    [[nodiscard]] const std::vector<size_t>& numbers() const { return numbers_; }
    [[nodiscard]] size_t memory() const;

 private:
    static constexpr size_t kNone = static_cast<size_t>(-1);
    struct NamedDesc {
        gpu::TextureDesc desc;
        std::string name;
    };
    struct Slot {
        gpu::Texture texture;
        size_t last_target = 0;  ///< the target that uses it last in a frame
    };
    struct History {
        std::string name;
        gpu::TextureDesc desc;
        gpu::Texture textures[2] = {};
        int now = 0;
        int frames = 0;  ///< frames since the last cut, at most 2: from then on the other texture is the last frame's
    };
    struct Owned {
        size_t target = 0;
        std::function<const gpu::Texture*()> texture;
    };
    /// Fills everything but the textures. Returns what each slot wants.
    std::vector<NamedDesc> lay_out(const GraphPlan& plan, glm::ivec2 frame_size);
    [[nodiscard]] const History* history(size_t target) const;

    std::vector<size_t> numbers_;  ///< of each target: into slots_, then into histories_, or kNone
    std::vector<Slot> slots_;
    std::vector<History> histories_;
    std::vector<Owned> owned_;  ///< by passes
};

}  // namespace tyndall
