#include "analytic/analytic_pass.h"

#include <epoxy/gl.h>
#include <fmt/format.h>

#include "light_volumes/quadrature.h"
#include "march/light_rectangle.h"
#include "march/march_pass.h"
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
    for (auto& [key, programs] : programs_) programs.begin();
    for (const Term& term : plan.terms(Solver::analytic)) draw(context, term);
    glDisable(GL_SCISSOR_TEST);
}

void AnalyticPass::draw(PassContext& context, const Term& term) {
    Frame& frame = context.frame();
    const ScreenRectangle rectangle =
        light_rectangle(frame.scene.lights[term.light], frame.block.view_projection, context.size());
    if (rectangle.empty()) return;
    glScissor(rectangle.low.x, rectangle.low.y, rectangle.size.x, rectangle.size.y);
    const gpu::Program& program =
        programs(media_->media()[term.medium].phase.kind).use(frame, term.light, [&](const gpu::Program& fresh) {
            frame.seams.bind(Seam::light_transmittance, fresh, context);
            media_->bind(fresh, settings_.light_steps);
            fresh.texture("phase_tables", media_->phase_tables(), {.filter = gpu::Filter::linear});
            fresh.texture("scene_depth", context.texture("scene_depth"), {.filter = gpu::Filter::nearest});
            fresh.set("farthest", kFarthest);
            const std::vector<glm::vec2> nodes = gauss_legendre(settings_.analytic.nodes);
            for (size_t i = 0; i < nodes.size(); ++i) fresh.set(fmt::format("nodes[{}]", i), nodes[i]);
        });
    program.set("light_index", static_cast<unsigned>(term.light));
    program.set("medium", static_cast<int>(term.medium));
    gpu::draw_fullscreen();
}

LightPrograms& AnalyticPass::programs(PhaseKind phase) {
    const bool one = media_->media().size() == 1;
    const auto key = std::tuple(phase, one, media_->even(), settings_.analytic.nodes);
    if (const auto known = programs_.find(key); known != programs_.end()) return known->second;
    gpu::ProgramDesc desc{.name = "participating_media.analytic",
                          .fragment = "participating_media/analytic/analytic.frag",
                          .defines = {"IGNORE_SHADOW_MAPS", fmt::format("NODES {}", settings_.analytic.nodes),
                                      fmt::format("PHASE_KIND {}", static_cast<int>(phase))}};
    if (one) desc.defines.emplace_back("ONE_MEDIUM");
    if (media_->even()) desc.defines.emplace_back("EVEN_MEDIA");
    return programs_.try_emplace(key, std::move(desc)).first->second;
}

}  // namespace tyndall::participating_media
