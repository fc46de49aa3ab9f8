#include "analytic/analytic_pass.h"

#include <epoxy/gl.h>
#include <fmt/format.h>

#include "light_rectangle.h"
#include "quadrature.h"
#include "render/draw_state.h"

namespace tyndall::participating_media {

std::string analytic_cannot(const RenderScene& scene, const Medium& medium, const Term& term) {
    if (term.source != Term::Source::light) return "renders the light of lamps and suns only";
    if (!std::holds_alternative<ConstantDensity>(medium.density) &&
        !std::holds_alternative<HeightDensity>(medium.density))
        return "cannot render a density without a closed form";
    if (scene.lights[term.light].shadow.enabled) return "cannot render a light that casts shadows";
    if (scene.lights[term.light].gobo) return "cannot render a gobo";
    return {};
}

void AnalyticPass::declare(PassDeclaration& declaration) {
    declaration.stage(Stage::media)
        .reads("scene_depth", "where rays end")
        .updates("media_in_scatter", "adds the light that meets no shadow")
        .after("participating_media.gather");
}

void AnalyticPass::execute(PassContext& context) {
    const SolverPlan& plan = media_->plan();
    if (!plan.uses(Solver::analytic)) return;
    context.bind_targets();
    const DrawState state(DepthState::off, BlendState::add);
    glEnable(GL_SCISSOR_TEST);
    programs_.begin();
    for (const Term& term : plan.terms(Solver::analytic)) draw(context, term);
    glDisable(GL_SCISSOR_TEST);
}

void AnalyticPass::draw(PassContext& context, const Term& term) {
    Frame& frame = context.frame();
    const ScreenRectangle rectangle =
        light_rectangle(frame.scene.lights[term.light], frame.block.view_projection, context.size());
    if (rectangle.empty()) return;
    glScissor(rectangle.low.x, rectangle.low.y, rectangle.size.x, rectangle.size.y);
    const PhaseKind phase = media_->media()[term.medium].phase.kind;
    const gpu::Program& program = programs_.of(phase).use(frame, term.light, [&](const gpu::Program& fresh) {
        bind_light_source(fresh, context, *media_, settings_.light_steps);
        fresh.texture("scene_depth", context.texture("scene_depth"), {.filter = gpu::Filter::nearest});
        fresh.set("farthest", kFarthest);
        const std::vector<glm::vec2> nodes = gauss_legendre(settings_.analytic.nodes);
        fresh.set("node_count", settings_.analytic.nodes);
        for (size_t i = 0; i < nodes.size(); ++i) fresh.set(fmt::format("nodes[{}]", i), nodes[i]);
    });
    program.set("light_index", static_cast<unsigned>(term.light));
    program.set("medium", static_cast<int>(term.medium));
    gpu::draw_fullscreen();
}

}  // namespace tyndall::participating_media
