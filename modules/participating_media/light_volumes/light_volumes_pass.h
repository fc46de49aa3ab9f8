#pragma once
/// The pass of polygonal light volumes.

#include <array>
#include <memory>
#include <string>
#include <string_view>

#include "light_volumes/light_meshes.h"
#include "media_buffer.h"
#include "media_programs.h"
#include "media_settings.h"
#include "render/frame.h"
#include "render/frame_graph.h"

namespace tyndall::participating_media {

/// Why polygonal light volumes cannot express a term, or nothing.
[[nodiscard]] std::string light_volumes_cannot(const RenderScene& scene, const Medium& medium, const Term& term);

/// Adds to `media_in_scatter` what lights scatter in even media, from meshes of their shadow maps (Billeter, Sintorn &
/// Assarsson 2010).
///
/// Where the paper evaluates the air-light integral at each face, a face here adds the integrals of the first Legendre
/// polynomials up to itself, so that all faces together give the moments of the light's visibility along the ray;
/// the light and the medium are looked at once for each pixel. Any phase function, colour and falloff then costs the
/// same for each face: a few multiplications.
class LightVolumesPass final : public Pass {
 public:
    /// `settings` must outlive the pass.
    LightVolumesPass(std::shared_ptr<MediaBuffer> media, const MediaSettings& settings)
        : media_(std::move(media)), settings_(settings) {}
    [[nodiscard]] std::string_view name() const override { return "participating_media.light_volumes"; }
    void declare(PassDeclaration& declaration) override;
    void execute(PassContext& context) override;

 private:
    /// The pass's own targets, of the frame's size.
    struct Targets {
        gpu::Texture spans, moments;
        gpu::Framebuffer spans_frame, moments_frame;
    };
    enum class Step { span, faces, resolve };
    void make_targets(glm::ivec2 size);
    void draw_term(PassContext& context, const Term& term);
    const gpu::Program& use(PassContext& context, Step step, const Term& term);
    void draw_faces(PassContext& context, const Term& term);
    void resolve(PassContext& context, const Term& term);
    [[nodiscard]] static MediaPrograms make_programs(std::string_view step);
    [[nodiscard]] int terms() const { return settings_.light_volumes.terms / 4 * 4; }
    /// A spot's light bends more sharply, at its edge, than the terms alone would need.
    [[nodiscard]] int nodes(const Light& light) const {
        return light.kind == LightKind::spot ? terms() * 3 / 2 : terms();
    }

    std::shared_ptr<MediaBuffer> media_;
    const MediaSettings& settings_;
    LightMeshes meshes_;
    Targets targets_;
    std::array<MediaPrograms, 3> programs_{make_programs("span"), make_programs("faces"), make_programs("resolve")};
};

}  // namespace tyndall::participating_media
