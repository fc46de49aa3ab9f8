#include "light_volumes/light_volumes_pass.h"

#include <epoxy/gl.h>
#include <fmt/format.h>

#include "light_rectangle.h"
#include "quadrature.h"
#include "render/draw_state.h"

namespace tyndall::participating_media {
namespace {

/// What the moments of visibility must cover: all media.
Bounds bounds_of(const std::vector<Medium>& media, const RenderScene& scene) {
    Bounds all;
    for (const Medium& medium : media) {
        const glm::mat4 box = medium_box(medium, scene);
        for (int corner = 0; corner < 8; ++corner) {
            const glm::vec4 local((corner & 1) != 0 ? 0.5f : -0.5f, (corner & 2) != 0 ? 0.5f : -0.5f,
                                  (corner & 4) != 0 ? 0.5f : -0.5f, 1.0f);
            all.low = glm::min(all.low, glm::vec3(box * local));
            all.high = glm::max(all.high, glm::vec3(box * local));
        }
    }
    return all;
}

}  // namespace

std::string light_volumes_cannot(const RenderScene& scene, const Medium& medium, const Term& term) {
    if (term.source != Term::Source::light) return "renders the light of lamps and suns only";
    if (!std::holds_alternative<ConstantDensity>(medium.density)) return "cannot render a density that varies";
    if (scene.lights[term.light].gobo) return "cannot render a gobo: its colours change along a ray";
    return {};
}

void LightVolumesPass::declare(PassDeclaration& declaration) {
    declaration.stage(Stage::media)
        .reads("scene_depth", "where rays end")
        .reads("shadow_maps", "where light ends")
        .updates("media_in_scatter", "adds what lights scatter")
        .after("participating_media.analytic");
}

void LightVolumesPass::make_targets(glm::ivec2 size) {
    const int layers = terms() / 4;
    const gpu::TextureDesc have = targets_.moments.desc();
    if (targets_.moments.name() != 0 && have.width == size.x && have.height == size.y && have.layers == layers) return;
    targets_ = {};
    targets_.spans =
        gpu::Texture({.format = gpu::Format::rgba32f, .width = size.x, .height = size.y}, "light volumes' spans");
    targets_.moments = gpu::Texture({.shape = gpu::Shape::array,
                                     .format = gpu::Format::rgba32f,
                                     .width = size.x,
                                     .height = size.y,
                                     .layers = layers},
                                    "light volumes' moments");
    std::vector<gpu::Framebuffer::Attachment> attachments;
    for (int layer = 0; layer < layers; ++layer) attachments.push_back({&targets_.moments, 0, layer});
    const gpu::Framebuffer::Attachment spans{&targets_.spans};
    targets_.spans_frame = gpu::Framebuffer(std::span(&spans, 1), {}, "light volumes' spans");
    targets_.moments_frame = gpu::Framebuffer(attachments, {}, "light volumes' moments");
}

void LightVolumesPass::execute(PassContext& context) {
    const SolverPlan& plan = media_->plan();
    if (!plan.uses(Solver::light_volumes)) return;
    make_targets(context.size());
    glEnable(GL_SCISSOR_TEST);
    for (const Term& term : plan.terms(Solver::light_volumes)) draw_term(context, term);
    glDisable(GL_SCISSOR_TEST);
}

void LightVolumesPass::draw_term(PassContext& context, const Term& term) {
    Frame& frame = context.frame();
    const ScreenRectangle rectangle =
        light_rectangle(frame.scene.lights[term.light], frame.block.view_projection, context.size());
    if (rectangle.empty()) return;
    glScissor(rectangle.low.x, rectangle.low.y, rectangle.size.x, rectangle.size.y);
    targets_.spans_frame.bind();
    use(context, Step::span, term)
        .texture("scene_depth", context.texture("scene_depth"), {.filter = gpu::Filter::nearest});
    gpu::draw_fullscreen();
    draw_faces(context, term);
    resolve(context, term);
}

void LightVolumesPass::draw_faces(PassContext& context, const Term& term) {
    Frame& frame = context.frame();
    targets_.moments_frame.bind();
    for (int layer = 0; layer < terms() / 4; ++layer) targets_.moments_frame.clear_colour(layer, glm::vec4(0.0f));
    if (!LightMeshes::has_shadows(frame, term.light)) return;
    use(context, Step::faces, term).texture("spans", targets_.spans, {.filter = gpu::Filter::nearest});
    const DrawState state(DepthState::off, BlendState::add);
    glEnable(GL_DEPTH_CLAMP);  // a face nearer than the near plane counts as well
    const LightVolumesSettings& detail = settings_.light_volumes;
    meshes_.draw(frame, term.light, bounds_of(media_->media(), frame.scene),
                 {detail.texels_per_quad, detail.adaptive ? detail.tolerance_m : -1.0f});
    glDisable(GL_DEPTH_CLAMP);
}

void LightVolumesPass::resolve(PassContext& context, const Term& term) {
    Frame& frame = context.frame();
    context.bind_targets();
    const gpu::Program& program = use(context, Step::resolve, term);
    program.texture("spans", targets_.spans, {.filter = gpu::Filter::nearest});
    program.texture("moments", targets_.moments, {.filter = gpu::Filter::nearest});
    const bool lit =
        frame.scene.lights[term.light].kind == LightKind::directional || !LightMeshes::has_shadows(frame, term.light);
    program.set("unshadowed", lit ? 1.0f : 0.0f);
    const std::vector<glm::vec2> places = gauss_legendre(nodes(frame.scene.lights[term.light]));
    for (size_t i = 0; i < places.size(); ++i) program.set(fmt::format("nodes[{}]", i), places[i]);
    const DrawState state(DepthState::off, BlendState::add);
    gpu::draw_fullscreen();
}

const gpu::Program& LightVolumesPass::use(PassContext& context, Step step, const Term& term) {
    Frame& frame = context.frame();
    // only the last step looks at the phase function
    const PhaseKind phase = step == Step::resolve ? media_->media()[term.medium].phase.kind : PhaseKind{};
    LightPrograms& variants =
        programs_.at(static_cast<size_t>(step)).of(phase, {terms(), nodes(frame.scene.lights[term.light])});
    variants.begin();
    const gpu::Program& program = variants.use(frame, term.light, [&](const gpu::Program& fresh) {
        if (step != Step::faces) bind_light_source(fresh, context, *media_, settings_.light_steps);
    });
    program.set("light_index", static_cast<unsigned>(term.light));
    program.set("medium", static_cast<int>(term.medium));
    program.set("farthest", kFarthest);
    return program;
}

MediaPrograms LightVolumesPass::make_programs(std::string_view step) {
    return MediaPrograms({.name = fmt::format("participating_media.light_volumes_{}", step),
                          .vertex = step == "faces" ? "participating_media/light_volumes/faces.vert" : "",
                          .fragment = fmt::format("participating_media/light_volumes/{}.frag", step),
                          .defines = {"IGNORE_SHADOW_MAPS"}},
                         {"TERMS", "NODES"});
}

}  // namespace tyndall::participating_media
