#pragma once
/// The passes that march single scattering: march, filter, gather.

#include <memory>

#include "march/march_terms.h"
#include "media_buffer.h"
#include "media_settings.h"
#include "render/frame_graph.h"

namespace tyndall::participating_media {

/// Of what is marched.
[[nodiscard]] TargetDesc marched_target(const MediaSettings& settings);

/// Writes `media_marched`: rgb single-scattered radiance between the eye and the surface (cd/m2), a its guide
/// (shaders/march/guide.glsl), at full, half or quarter resolution.
class MarchPass final : public Pass {
 public:
    /// `settings` must outlive the pass.
    MarchPass(std::shared_ptr<MediaBuffer> media, std::shared_ptr<MarchTerms> terms, const MediaSettings& settings)
        : media_(std::move(media)), terms_(std::move(terms)), settings_(settings) {}
    [[nodiscard]] std::string_view name() const override { return "participating_media.march"; }
    void declare(PassDeclaration& declaration) override;
    void execute(PassContext& context) override;

 private:
    std::shared_ptr<MediaBuffer> media_;
    std::shared_ptr<MarchTerms> terms_;
    const MediaSettings& settings_;
};

/// Below full resolution: sums 3x3 marched pixels of like distance into `media_marched_filtered`; the errors of the
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
/// (m), at the frame's resolution; the other solvers add to it. At full resolution it filters 3x3 pixels of like
/// distance. Below, it upsamples what part of the guide was found, times the guide of each pixel, and marches the
/// pixels of which marched pixels say too little.
class GatherPass final : public Pass {
 public:
    GatherPass(std::shared_ptr<MediaBuffer> media, std::shared_ptr<MarchTerms> terms, const MediaSettings& settings)
        : media_(std::move(media)), terms_(std::move(terms)), settings_(settings) {}
    [[nodiscard]] std::string_view name() const override { return "participating_media.gather"; }
    void declare(PassDeclaration& declaration) override;
    void execute(PassContext& context) override;

 private:
    void draw(PassContext& context, const gpu::ProgramDesc& desc);
    void upsample(PassContext& context);
    void add_shares(PassContext& context);
    void make_list(glm::ivec2 size);
    std::shared_ptr<MediaBuffer> media_;
    std::shared_ptr<MarchTerms> terms_;
    const MediaSettings& settings_;
    gpu::Buffer list_;  ///< UnknownPixels of main.glsl: an indirect dispatch, a count, pixels
};

}  // namespace tyndall::participating_media
