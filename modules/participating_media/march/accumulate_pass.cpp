#include "march/accumulate_pass.h"

#include "march/march_pass.h"
#include "render/frame.h"

namespace tyndall::participating_media {

void AccumulatePass::declare(PassDeclaration& declaration) {
    declaration.stage(Stage::media);
    if (!settings_.temporal) return;
    TargetDesc target = marched_target(settings_);
    target.history = true;
    declaration.reads("media_marched", "this frame's")
        .reads("scene_depth", "where rays end")
        .reads("media_accumulated@previous", "the last frames'", true)
        .writes("media_accumulated", target, "the mean over frames");
}

void AccumulatePass::execute(PassContext& context) {
    static const gpu::ProgramDesc kDesc{.name = "participating_media.accumulate",
                                        .fragment = "participating_media/march/accumulate.frag",
                                        .defines = {"GUIDE_ONLY"}};
    if (!media_->plan().uses(Solver::ray_marched)) return;
    const gpu::Texture* previous = context.find_texture("media_accumulated@previous");
    const gpu::Texture& marched = context.texture("media_marched");
    context.bind_targets();
    const gpu::Program& program = context.frame().shaders.program(kDesc);
    program.use();
    bind_frame(program, context.frame());
    MarchTerms::bind_ray(program, context, media_->bounds(), pixel_step(settings_.resolution));
    program.texture("marched", marched, {.filter = gpu::Filter::nearest});
    program.texture("before", previous != nullptr ? *previous : marched, {.filter = gpu::Filter::linear});
    program.set("frames", previous != nullptr ? terms_->history().frames() : 0);
    gpu::draw_fullscreen();
}

}  // namespace tyndall::participating_media
