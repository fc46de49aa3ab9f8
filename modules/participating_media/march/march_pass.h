#pragma once
/// The passes that march single scattering: march, filter, gather.

#include <memory>

#include "media_buffer.h"
#include "media_programs.h"
#include "media_settings.h"
#include "render/frame.h"
#include "render/frame_graph.h"

namespace tyndall::participating_media {

/// Writes `media_marched`: rgb single-scattered radiance between the eye and the surface (cd/m2), a the distance
/// marched (m), at full or half resolution.
class MarchPass final : public Pass {
 public:
    /// `settings` must outlive the pass.
    MarchPass(std::shared_ptr<MediaBuffer> media, const MediaSettings& settings)
        : media_(std::move(media)), settings_(settings) {}
    [[nodiscard]] std::string_view name() const override { return "participating_media.march"; }
    void declare(PassDeclaration& declaration) override;
    void execute(PassContext& context) override;

 private:
    void draw_distance(PassContext& context);
    void draw_light(PassContext& context, size_t light, int medium);
    /// What lights a medium evenly: its own emission, or light from all around.
    void draw_glow(PassContext& context, Term::Source source, int medium);
    void bind_march(const gpu::Program& program, PassContext& context) const;
    void bind_common(const gpu::Program& program, PassContext& context) const;

    std::shared_ptr<MediaBuffer> media_;
    const MediaSettings& settings_;
    gpu::Texture blue_noise_;
    MediaPrograms programs_{{.name = "participating_media.march", .fragment = "participating_media/march/march.frag"}};
};

/// At half resolution: averages 5x5 marched pixels of like distance into `media_marched_filtered`; the errors of the
/// blue-noise mask cancel there.
class FilterPass final : public Pass {
 public:
    FilterPass(std::shared_ptr<MediaBuffer> media, const MediaSettings& settings)
        : media_(std::move(media)), settings_(settings) {}
    [[nodiscard]] std::string_view name() const override { return "participating_media.filter"; }
    void declare(PassDeclaration& declaration) override;
    void execute(PassContext& context) override;

 private:
    std::shared_ptr<MediaBuffer> media_;
    const MediaSettings& settings_;
};

/// Creates `media_in_scatter`: rgb single-scattered radiance between the eye and the surface (cd/m2), a that distance
/// (m), at the frame's resolution. Upsamples what was marched by depth, or filters 3x3 pixels of like distance; the
/// other solvers add to it.
class GatherPass final : public Pass {
 public:
    GatherPass(std::shared_ptr<MediaBuffer> media, const MediaSettings& settings)
        : media_(std::move(media)), settings_(settings) {}
    [[nodiscard]] std::string_view name() const override { return "participating_media.gather"; }
    void declare(PassDeclaration& declaration) override;
    void execute(PassContext& context) override;

 private:
    [[nodiscard]] const gpu::ProgramDesc& program() const;
    std::shared_ptr<MediaBuffer> media_;
    const MediaSettings& settings_;
};

}  // namespace tyndall::participating_media
