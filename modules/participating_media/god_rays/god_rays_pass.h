#pragma once
/// The pass of screen-space god rays.

#include <memory>
#include <string>

#include "media_buffer.h"
#include "media_programs.h"
#include "media_settings.h"
#include "render/frame.h"
#include "render/frame_graph.h"

namespace tyndall::participating_media {

/// Why god rays cannot express a term, or nothing.
[[nodiscard]] std::string god_rays_cannot(const RenderScene& scene, const Medium& medium, const Term& term);

/// Adds to `media_in_scatter` what a directional light scatters in the scene's one even medium: the closed form without
/// shadows, times the share of it that the surfaces on the way to the sun on the screen leave (Mitchell 2007).
class GodRaysPass final : public Pass {
 public:
    /// `settings` must outlive the pass.
    GodRaysPass(std::shared_ptr<MediaBuffer> media, const MediaSettings& settings)
        : media_(std::move(media)), settings_(settings) {}
    [[nodiscard]] std::string_view name() const override { return "participating_media.god_rays"; }
    void declare(PassDeclaration& declaration) override;
    void execute(PassContext& context) override;

 private:
    void draw_term(PassContext& context, const Term& term);

    std::shared_ptr<MediaBuffer> media_;
    const MediaSettings& settings_;
    MediaPrograms programs_{{.name = "participating_media.god_rays",
                             .fragment = "participating_media/god_rays/god_rays.frag",
                             .defines = {"IGNORE_SHADOW_MAPS"}}};
};

}  // namespace tyndall::participating_media
