#pragma once
/// The solver analytic: light that meets no shadow, without a march.

#include <memory>
#include <string>

#include "media_buffer.h"
#include "media_programs.h"
#include "media_settings.h"
#include "render/frame_graph.h"

namespace tyndall::participating_media {

/// Why a term has no smooth integrand, or nothing.
[[nodiscard]] std::string analytic_cannot(const RenderScene& scene, const Medium& medium, const Term& term);

/// Adds to `media_in_scatter` the light of lights that cast no shadow, in even media and height fog: Sun et al.'s air
/// light ("A Practical Analytic Single Scattering Model", 2005), which is an integral over an angle too, with any phase
/// function, cone, range and bounds.
class AnalyticPass final : public Pass {
 public:
    /// `settings` must outlive the pass.
    AnalyticPass(std::shared_ptr<MediaBuffer> media, const MediaSettings& settings)
        : media_(std::move(media)), settings_(settings) {}
    [[nodiscard]] std::string_view name() const override { return "participating_media.analytic"; }
    void declare(PassDeclaration& declaration) override;
    void execute(PassContext& context) override;

 private:
    void draw(PassContext& context, const Term& term);

    std::shared_ptr<MediaBuffer> media_;
    const MediaSettings& settings_;
    MediaPrograms programs_{{.name = "participating_media.analytic",
                             .fragment = "participating_media/analytic/analytic.frag",
                             .defines = {"IGNORE_SHADOW_MAPS"}}};
};

}  // namespace tyndall::participating_media
