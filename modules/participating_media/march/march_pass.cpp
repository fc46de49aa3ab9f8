#include "march/march_pass.h"

#include <epoxy/gl.h>
#include <fmt/format.h>

#include "light_rectangle.h"
#include "media_textures.h"

namespace tyndall::participating_media {
namespace {

int pixel_step(const MediaSettings& settings) {
    return settings.resolution == Resolution::half ? 2 : 1;
}

TargetDesc marched_target(const MediaSettings& settings) {
    return {.format = gpu::Format::rgba32f, .scale = 1.0f / static_cast<float>(pixel_step(settings))};
}

bool filters_apart(const MediaSettings& settings) {
    return settings.filter && settings.resolution != Resolution::full;
}

}  // namespace

void MarchPass::declare(PassDeclaration& declaration) {
    declaration.stage(Stage::media).reads("scene_depth", "where rays end");
    declaration.writes("media_marched", marched_target(settings_),
                       "single-scattered radiance between the eye and the surface, and the distance marched");
}

void MarchPass::execute(PassContext& context) {
    if (blue_noise_.name() == 0) blue_noise_ = make_blue_noise();
    if (!media_->plan().uses(Solver::ray_marched)) return;
    context.bind_targets();
    draw_distance(context);
    glEnable(GL_BLEND);
    glBlendFuncSeparate(GL_ONE, GL_ONE, GL_ZERO, GL_ONE);  // the distance stays
    programs_.begin();
    for (const Term& term : media_->plan().terms(Solver::ray_marched)) {
        if (term.source == Term::Source::light)
            draw_light(context, term.light, static_cast<int>(term.medium));
        else
            draw_glow(context, term.source, static_cast<int>(term.medium));
    }
    glDisable(GL_BLEND);
}

void MarchPass::draw_glow(PassContext& context, Term::Source source, int medium) {
    static const gpu::ProgramDesc kEmission{.name = "participating_media.emission",
                                            .fragment = "participating_media/march/emission.frag"};
    static const gpu::ProgramDesc kEnvironment{.name = "participating_media.environment",
                                               .fragment = "participating_media/march/environment.frag"};
    const bool own = source == Term::Source::emission;
    const gpu::Program& program = context.frame().shaders.program(own ? kEmission : kEnvironment);
    program.use();
    if (!own) media_->environment().bind(program);
    bind_frame(program, context.frame());
    bind_march(program, context);
    program.set("medium", medium);
    gpu::draw_fullscreen();
    programs_.begin();  // the lights' program is no longer in use
}

void MarchPass::draw_distance(PassContext& context) {
    static const gpu::ProgramDesc kDesc{.name = "participating_media.distance",
                                        .fragment = "participating_media/march/distance.frag"};
    const gpu::Program& program = context.frame().shaders.program(kDesc);
    program.use();
    bind_frame(program, context.frame());
    bind_common(program, context);
    gpu::draw_fullscreen();
}

void MarchPass::draw_light(PassContext& context, size_t light, int medium) {
    Frame& frame = context.frame();
    const glm::ivec2 size = glm::max(context.size() / pixel_step(settings_), glm::ivec2(1));
    const ScreenRectangle rectangle = light_rectangle(frame.scene.lights[light], frame.block.view_projection, size);
    if (rectangle.empty()) return;
    const gpu::Program& program = programs_.of(*media_, media_->media()[static_cast<size_t>(medium)].phase.kind)
                                      .use(frame, light, [&](const gpu::Program& fresh) {
                                          bind_light_source(fresh, context, *media_, settings_.light_steps);
                                          bind_march(fresh, context);
                                      });
    program.set("light_index", static_cast<unsigned>(light));
    program.set("medium", medium);
    glEnable(GL_SCISSOR_TEST);
    glScissor(rectangle.low.x, rectangle.low.y, rectangle.size.x, rectangle.size.y);
    gpu::draw_fullscreen();
    glDisable(GL_SCISSOR_TEST);
}

void MarchPass::bind_march(const gpu::Program& program, PassContext& context) const {
    bind_common(program, context);
    media_->bind(program, settings_.light_steps);
    program.texture("blue_noise", blue_noise_,
                    {.filter = gpu::Filter::nearest, .wrap_u = gpu::Wrap::repeat, .wrap_v = gpu::Wrap::repeat});
    program.set("steps", settings_.steps);
    program.set("once", 1);
    program.set("fixed_offset", settings_.jitter ? -1.0f : 0.5f);
}

void MarchPass::bind_common(const gpu::Program& program, PassContext& context) const {
    program.texture("scene_depth", context.texture("scene_depth"), {.filter = gpu::Filter::nearest});
    program.set("pixel_step", pixel_step(settings_));
    program.set("farthest", kFarthest);
}

void FilterPass::declare(PassDeclaration& declaration) {
    declaration.stage(Stage::media);
    if (!filters_apart(settings_)) return;
    declaration.reads("media_marched", "grainy")
        .writes("media_marched_filtered", marched_target(settings_), "the same without its grain");
}

void FilterPass::execute(PassContext& context) {
    static const gpu::ProgramDesc kDesc{.name = "participating_media.filter",
                                        .fragment = "participating_media/march/filter.frag",
                                        .defines = {"RADIUS 2"}};
    if (!media_->plan().uses(Solver::ray_marched)) return;
    context.bind_targets();
    const gpu::Program& program = context.frame().shaders.program(kDesc);
    program.use();
    program.texture("marched", context.texture("media_marched"), {.filter = gpu::Filter::nearest});
    gpu::draw_fullscreen();
}

void GatherPass::declare(PassDeclaration& declaration) {
    declaration.stage(Stage::media)
        .reads("scene_depth", "where rays end")
        .reads(filters_apart(settings_) ? "media_marched_filtered" : "media_marched", "what the march found")
        .writes("media_in_scatter", {.format = gpu::Format::rgba32f},
                "single-scattered radiance between the eye and the surface, and that distance");
}

const gpu::ProgramDesc& GatherPass::program() const {
    static const gpu::ProgramDesc kNothing{.name = "participating_media.distance",
                                           .fragment = "participating_media/march/distance.frag"};
    static const gpu::ProgramDesc kUpsample{.name = "participating_media.upsample",
                                            .fragment = "participating_media/march/upsample.frag"};
    static const gpu::ProgramDesc kFilter{.name = "participating_media.filter",
                                          .fragment = "participating_media/march/filter.frag",
                                          .defines = {"RADIUS 1"}};
    static const gpu::ProgramDesc kCopy{.name = "participating_media.copy",
                                        .fragment = "participating_media/march/filter.frag",
                                        .defines = {"RADIUS 0"}};
    if (!media_->plan().uses(Solver::ray_marched)) return kNothing;
    if (settings_.resolution != Resolution::full) return kUpsample;
    return settings_.filter ? kFilter : kCopy;
}

void GatherPass::execute(PassContext& context) {
    context.bind_targets();
    const gpu::Program& program = context.frame().shaders.program(this->program());
    program.use();
    bind_frame(program, context.frame());
    program.texture("scene_depth", context.texture("scene_depth"), {.filter = gpu::Filter::nearest});
    program.texture("marched", context.texture(filters_apart(settings_) ? "media_marched_filtered" : "media_marched"),
                    {.filter = gpu::Filter::nearest});
    program.set("pixel_step", 1);
    program.set("farthest", kFarthest);
    gpu::draw_fullscreen();
}

}  // namespace tyndall::participating_media
