#pragma once
/// The pass that marches single scattering, and the one that takes its grain off.

#include <map>
#include <memory>
#include <tuple>

#include "march_settings.h"
#include "media_buffer.h"
#include "render/frame.h"
#include "render/frame_graph.h"
#include "render/light_programs.h"
#include "render/seams.h"

namespace tyndall::participating_media {

/// Marched target: rgb single-scattered radiance between the eye and the surface (cd/m2), a the distance marched (m).
/// Full or half resolution by MarchSettings. What the media-segment seam reads is `media_in_scatter`, which this pass
/// writes when nothing filters it.
class MarchPass final : public Pass {
 public:
    /// `settings` must outlive the pass.
    MarchPass(std::shared_ptr<MediaBuffer> media, const MarchSettings& settings)
        : media_(std::move(media)), settings_(settings) {}
    [[nodiscard]] std::string_view name() const override { return "participating_media.march"; }
    void declare(PassDeclaration& declaration) override;
    void execute(PassContext& context) override;

 private:
    void draw_distance(PassContext& context);
    void draw_light(PassContext& context, size_t light, int medium);
    void draw_emission(PassContext& context, int medium);
    void bind_march(const gpu::Program& program, PassContext& context) const;
    void bind_common(const gpu::Program& program, PassContext& context) const;
    /// Programs for this phase function, for one medium or several, even ones or any.
    [[nodiscard]] LightPrograms& programs(PhaseKind phase);

    std::shared_ptr<MediaBuffer> media_;
    const MarchSettings& settings_;
    gpu::Texture blue_noise_;
    std::map<std::tuple<PhaseKind, bool, bool>, LightPrograms> programs_;
};

/// Averages 3x3 (half resolution: 5x5) marched pixels of like distance: the errors of the blue-noise mask cancel there.
class FilterPass final : public Pass {
 public:
    explicit FilterPass(const MarchSettings& settings) : settings_(settings) {}
    [[nodiscard]] std::string_view name() const override { return "participating_media.filter"; }
    void declare(PassDeclaration& declaration) override;
    void execute(PassContext& context) override;

 private:
    const MarchSettings& settings_;
};

}  // namespace tyndall::participating_media
