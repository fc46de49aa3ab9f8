#pragma once
/// What one pass of a built graph sees while it runs.

#include <array>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "render/frame_graph.h"
#include "render/graph_plan.h"
#include "render/graph_textures.h"

namespace tyndall {

/// Finds a pass's targets by name and keeps the framebuffers that it binds. Allocates nothing once they exist.
class GraphPassContext final : public PassContext {
 public:
    /// `targets` maps names to places in the plan.
    GraphPassContext(const DeclaredPass& pass, const GraphPlan& plan,
                     const std::unordered_map<std::string_view, size_t>& targets);

    /// Before the pass executes: clears what it creates.
    void begin(Frame& frame, const GraphTextures& textures, glm::ivec2 size);

    /// Throws Error for a target that the pass did not declare or that has no content.
    [[nodiscard]] const gpu::Texture& texture(std::string_view target) const override;
    [[nodiscard]] const gpu::Texture* find_texture(std::string_view target) const override;
    void bind_targets() override;
    void bind_targets(std::span<const std::string_view> targets, int layer, int mip) override;
    [[nodiscard]] glm::ivec2 size() const override { return size_; }
    [[nodiscard]] Frame& frame() override { return *frame_; }

 private:
    static constexpr size_t kAbsent = static_cast<size_t>(-1);
    static constexpr size_t kMaxColours = 8;
    struct Binding {
        std::string name;         ///< as the pass asks for it: with "@previous"
        size_t target = kAbsent;  ///< place in the plan; an optional read may have none
        PassDeclaration::Access::Kind kind;
        bool previous = false;
        std::optional<glm::vec4> clear;
    };
    /// What a framebuffer is made of, colours first; unused entries have no texture.
    struct Attachments {
        std::array<gpu::Framebuffer::Attachment, kMaxColours> colours{};
        gpu::Framebuffer::Attachment depth{};
        size_t count = 0;  ///< of colours
    };
    struct Cached {
        Attachments attachments;
        gpu::Framebuffer framebuffer;
    };

    [[nodiscard]] const Binding* find(std::string_view name) const;
    [[nodiscard]] const gpu::Texture* texture_of(const Binding& binding) const;
    void add(Attachments& attachments, const Binding& binding, int layer, int mip) const;
    [[nodiscard]] const gpu::Framebuffer& framebuffer(const Attachments& attachments);
    void clear(const Binding& binding);

    std::string pass_;
    std::vector<Binding> bindings_;
    std::vector<Cached> framebuffers_;
    Frame* frame_ = nullptr;
    const GraphTextures* textures_ = nullptr;
    glm::ivec2 size_{0};
};

}  // namespace tyndall
