// The module: what it registers.

#include "analytic/analytic_pass.h"
#include "analytic/surface_glow.h"
#include "epipolar/epipolar_pass.h"
#include "froxels/froxel_pass.h"
#include "god_rays/god_rays_pass.h"
#include "light_volumes/light_volumes_pass.h"
#include "march/accumulate_pass.h"
#include "march/march_pass.h"
#include "medium_component.h"
#include "module/module.h"
#include "segment.h"
#include "shadows/media_shadows.h"

namespace tyndall::participating_media {

class ParticipatingMedia final : public Module {
 public:
    void install(Registrar& registrar) override {
        const auto media = std::make_shared<MediaBuffer>();
        registrar.component<MediumComponent>(extract_medium);
        const MediaSettings& settings = registrar.settings<MediaSettings>();
        const auto march = std::make_shared<MarchTerms>(media, settings);
        registrar.pass(std::make_unique<UploadPass>(media, settings));
        const auto shadows = std::make_shared<MediaShadows>();
        registrar.pass(std::make_unique<MediaShadowsPass>(media, shadows, settings));
        registrar.pass(std::make_unique<MarchPass>(media, march, settings));
        registrar.pass(std::make_unique<AccumulatePass>(media, march, settings));
        registrar.pass(std::make_unique<FilterPass>(media, settings));
        registrar.pass(std::make_unique<GatherPass>(media, march, settings));
        registrar.pass(std::make_unique<AnalyticPass>(media, settings));
        registrar.pass(std::make_unique<LightVolumesPass>(media, settings));
        registrar.pass(std::make_unique<EpipolarPass>(media, settings));
        registrar.pass(std::make_unique<GodRaysPass>(media, settings));
        const auto froxels = std::make_shared<FroxelVolume>();
        registrar.pass(std::make_unique<FroxelPass>(media, froxels, settings));
        const auto bind_media = [media, &settings](const gpu::Program& program, PassContext&) {
            media->bind(program, settings.light_steps);
        };
        registrar.seam(Seam::light_transmittance,
                       {.name = "participating_media",
                        .include = "participating_media/transmittance.glsl",
                        .function = "participating_media_transmittance",
                        .reads = {"media_shadows"},
                        .bind = [bind_media, shadows, &settings](const gpu::Program& program, PassContext& context) {
                            bind_media(program, context);
                            shadows->bind(program, settings);
                        }});
        registrar.seam(Seam::indirect_light, {.name = "participating_media",
                                              .include = "participating_media/analytic/surface_glow.glsl",
                                              .function = "participating_media_surface_glow",
                                              .bind = [bind_media, media, glow = std::make_shared<SurfaceGlow>(),
                                                       &settings](const gpu::Program& program, PassContext& context) {
                                                  bind_media(program, context);
                                                  glow->bind(program, context.frame().scene, *media, settings);
                                              }});
        registrar.seam(Seam::media_segment,
                       {.name = "participating_media",
                        .include = "participating_media/segment.glsl",
                        .function = "participating_media_segment",
                        .reads = {"media_in_scatter"},
                        .bind = [media, froxels, &settings](const gpu::Program& program, PassContext& context) {
                            bind_segment(program, context, *media, *froxels, settings);
                        }});
    }
};

}  // namespace tyndall::participating_media

TYNDALL_MODULE(tyndall::participating_media::ParticipatingMedia, "0.1",
               "Single scattering in fog, dust, smoke and water, by several solvers.", "")
