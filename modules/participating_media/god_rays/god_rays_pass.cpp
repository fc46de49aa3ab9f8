#include "god_rays/god_rays_pass.h"

#include <fmt/format.h>

#include "render/draw_state.h"

namespace tyndall::participating_media {

std::string god_rays_cannot(const RenderScene& scene, const Medium& medium, const Term& term) {
    if (term.source != Term::Source::light) return "renders the light of lamps and suns only";
    if (scene.lights[term.light].kind != LightKind::directional) return "can render directional lights alone";
    if (scene.lights[term.light].gobo) return "cannot render a gobo";
    if (!std::holds_alternative<ConstantDensity>(medium.density)) return "cannot render a density that varies";
    if (medium.shape == MediumShape::ellipsoid) return "cannot render an ellipsoid: its way in for light is no line";
    if (scene.media.size() != 1) return "cannot render one of several media";
    return {};
}

void GodRaysPass::declare(PassDeclaration& declaration) {
    declaration.stage(Stage::media)
        .reads("scene_depth", "where rays end, and what stands in the light's way")
        .updates("media_in_scatter", "adds what the sun scatters")
        .after("participating_media.epipolar");
}

void GodRaysPass::execute(PassContext& context) {
    const SolverPlan& plan = media_->plan();
    if (!plan.uses(Solver::god_rays)) return;
    context.bind_targets();
    const DrawState state(DepthState::off, BlendState::add);
    programs_.begin();
    for (const Term& term : plan.terms(Solver::god_rays)) draw_term(context, term);
}

void GodRaysPass::draw_term(PassContext& context, const Term& term) {
    Frame& frame = context.frame();
    const PhaseKind phase = media_->media()[term.medium].phase.kind;
    const gpu::Program& program = programs_.of(phase).use(frame, term.light, [&](const gpu::Program& fresh) {
        bind_light_source(fresh, context, *media_, settings_.light_steps);
        fresh.texture("scene_depth", context.texture("scene_depth"), {.filter = gpu::Filter::nearest});
    });
    const glm::vec3 to_sun(frame.scene.lights[term.light].transform[2]);
    const glm::vec4 clip = frame.block.view_projection * glm::vec4(to_sun, 0.0f);
    program.set("sun_clip", glm::vec3(clip.x, clip.y, clip.w));
    program.set("light_index", static_cast<unsigned>(term.light));
    program.set("farthest", kFarthest);
    program.set("samples", settings_.god_rays.samples);
    program.set("thickness", settings_.god_rays.thickness_m);
    program.set("edge_fade", settings_.god_rays.edge_fade);
    gpu::draw_fullscreen();
}

}  // namespace tyndall::participating_media
