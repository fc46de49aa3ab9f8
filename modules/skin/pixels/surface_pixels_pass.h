#pragma once
/// What skin is like at each pixel, for passes between the light pass and the compose pass, in both render paths.

#include <memory>

#include "render/frame_graph.h"
#include "render/kept.h"
#include "screen/screen_settings.h"
#include "skin_plan.h"

namespace tyndall::skin {

/// Draws skin once more, where it is seen, into the target `skin_pixels`: base colour^pre_scatter of techniques on the
/// screen (else 1) where no G-buffer has the colour, and metres of the body's thickness (below 0: not known). Leaves
/// the target alone when no skin of the scene has either.
class SurfacePixelsPass final : public Pass {
 public:
    explicit SurfacePixelsPass(const SkinSettings& settings) : settings_(settings) {}

    [[nodiscard]] std::string_view name() const override { return "skin.pixels"; }
    void declare(PassDeclaration& declaration) override;
    void execute(PassContext& context) override;

 private:
    /// On the GPU: rows of vertices.
    struct Vertices {
        std::shared_ptr<const SurfaceThickness> made_from;
        gpu::Texture list;
    };

    void draw(PassContext& context, const Surface& surface, bool coloured);
    const gpu::Texture& vertices_of(const Surface& surface);

    const SkinSettings& settings_;
    Kept<uint64_t, Vertices> vertices_;  ///< by mesh
};

}  // namespace tyndall::skin
