#pragma once
/// The pass of epipolar sampling.

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "media_buffer.h"
#include "media_programs.h"
#include "media_settings.h"
#include "render/frame.h"
#include "render/frame_graph.h"

namespace tyndall::participating_media {

/// Why epipolar sampling cannot express a term, or nothing.
[[nodiscard]] std::string epipolar_cannot(const RenderScene& scene, const Medium& medium, const Term& term);

/// Adds to `media_in_scatter` what a spot or directional light scatters in any medium: marched at few samples of few
/// lines through the light's place on the screen, and interpolated between (Engelhardt & Dachsbacher 2010), with a tree
/// over the shadow map's depths along each line (Chen et al. 2011; Yusov 2013).
class EpipolarPass final : public Pass {
 public:
    /// `settings` must outlive the pass.
    EpipolarPass(std::shared_ptr<MediaBuffer> media, const MediaSettings& settings)
        : media_(std::move(media)), settings_(settings) {}
    [[nodiscard]] std::string_view name() const override { return "participating_media.epipolar"; }
    void declare(PassDeclaration& declaration) override;
    void execute(PassContext& context) override;

 private:
    /// What the shaders share: columns are slices.
    struct Targets {
        gpu::Texture ends, distances, sources, tree, looks, lines;
    };
    enum class Step { slices, distances, sources, tree_leaves, tree, march, interpolate, unwarp };
    void make_targets();
    void draw_term(PassContext& context, const Term& term);
    void make_lines(PassContext& context, const Term& term);
    void make_tree(PassContext& context, const Term& term);
    const gpu::Program& use(PassContext& context, Step step, const Term& term);
    void dispatch(int rows) const;
    [[nodiscard]] static std::vector<MediaPrograms> make_programs();
    /// Along a slice: whole initial steps and one at the end.
    [[nodiscard]] int samples() const;
    [[nodiscard]] int shadow_samples() const;
    /// Densities that vary leave less alike along a line.
    [[nodiscard]] int initial_step() const;

    std::shared_ptr<MediaBuffer> media_;
    const MediaSettings& settings_;
    Targets targets_;
    std::vector<MediaPrograms> programs_ = make_programs();  ///< by Step
};

}  // namespace tyndall::participating_media
