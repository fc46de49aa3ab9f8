#pragma once
/// The solver froxels: single scattering in a view-aligned grid (Hillaire, "Physically Based and Unified Volumetric
/// Rendering in Frostbite", 2015; Wronski 2014).

#include <memory>
#include <string>
#include <vector>

#include "froxels/froxel_beyond.h"
#include "froxels/froxel_history.h"
#include "froxels/froxel_volume.h"
#include "media_buffer.h"
#include "media_settings.h"
#include "render/frame_graph.h"
#include "render/light_programs.h"

namespace tyndall::participating_media {

/// Why the froxels cannot express a term; empty: they can express all.
[[nodiscard]] std::string froxels_cannot(const RenderScene& scene, const Medium& medium, const Term& term);

/// Adds the froxels' terms to `media_in_scatter`: columns, sources light by light, sum front to back, then a pixel
/// each.
class FroxelPass final : public Pass {
 public:
    /// `settings` must outlive the pass.
    FroxelPass(std::shared_ptr<MediaBuffer> media, std::shared_ptr<FroxelVolume> volume, const MediaSettings& settings)
        : media_(std::move(media)), volume_(std::move(volume)), settings_(settings) {}
    [[nodiscard]] std::string_view name() const override { return "participating_media.froxels"; }
    void declare(PassDeclaration& declaration) override;
    void execute(PassContext& context) override;

 private:
    [[nodiscard]] const std::vector<Term>& terms() const { return media_->plan().terms(Solver::froxels); }
    void find_columns(PassContext& context);
    void begin_sources(PassContext& context);
    void add_lights(PassContext& context);
    void add_light(PassContext& context, LightPrograms& programs, size_t light, unsigned bits);
    /// What lights a medium evenly: its own emission, or light from all around.
    void add_glow(PassContext& context, Term::Source source);
    void integrate(PassContext& context);
    void apply(PassContext& context);
    /// Sets what sample.glsl and scattering.glsl declare.
    void bind_samples(const gpu::Program& program, PassContext& context) const;
    void dispatch(const glm::ivec3& froxels) const;
    [[nodiscard]] bool keeps_history() const { return settings_.froxels.history && !settings_.froxels.reference; }

    std::shared_ptr<MediaBuffer> media_;
    std::shared_ptr<FroxelVolume> volume_;
    const MediaSettings& settings_;
    FroxelHistory history_;
    gpu::Texture blue_noise_;
    MediaPrograms light_programs_{
        {.name = "participating_media.froxels.light", .compute = "participating_media/froxels/light.comp"}};
    FroxelBeyond beyond_;
};

}  // namespace tyndall::participating_media
