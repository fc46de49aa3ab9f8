#pragma once
/// The pass that marches single scattering into `media_in_scatter`.

#include <memory>

#include "march_settings.h"
#include "media_buffer.h"
#include "render/frame.h"
#include "render/frame_graph.h"
#include "render/seams.h"

namespace tyndall::participating_media {

/// Reads scene_depth; writes media_in_scatter: rgb single-scattered radiance between the eye and the surface (cd/m2), a
/// the distance marched (m). Full or half resolution by MarchSettings.
class MarchPass final : public Pass {
 public:
    /// `settings` must outlive the pass.
    MarchPass(std::shared_ptr<MediaBuffer> media, const MarchSettings& settings)
        : media_(std::move(media)), settings_(settings) {}
    [[nodiscard]] std::string_view name() const override { return "participating_media.march"; }
    void declare(PassDeclaration& declaration) override;
    void execute(PassContext& context) override;

 private:
    std::shared_ptr<MediaBuffer> media_;
    const MarchSettings& settings_;
    gpu::Texture blue_noise_;
};

}  // namespace tyndall::participating_media
