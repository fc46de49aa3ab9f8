#include "paint/paint_passes.h"

#include <epoxy/gl.h>

#include <algorithm>

#include "render/draw_state.h"
#include "render/frame.h"
#include "render/gpu_scene.h"
#include "render/material_table.h"
#include "render/seams.h"

namespace tyndall::translucency {
namespace {

constexpr const char *kShare = "paint_share", *kLight = "paint_light";

/// Techniques that the light pass does.
constexpr Technique kQuick[] = {Technique::wrap, Technique::thickness};

bool any_paint(const RenderScene& scene) {
    return std::ranges::any_of(scene.surfaces, is_painted);
}

}  // namespace

PaintMarkPass::PaintMarkPass(std::shared_ptr<TechniquePlan> plan, const TranslucencySettings& settings)
    : plan_(std::move(plan)),
      settings_(settings),
      programs_({.name = "translucency.paint.plain", .compute = "translucency/paint/plain_light.comp"}) {}

void PaintMarkPass::declare(PassDeclaration& declaration) {
    declare_pixels(declaration);
    declaration.writes(kShare, {.format = gpu::Format::rgba8}, "share of the base that is paint over a solid")
        .writes(kLight, {.format = gpu::Format::rgba16f}, "light that arrives at paint over a solid")
        .after("skin.transmission_map")  // where that module is loaded: the last of its passes, on pixels of its own
        .after("skin.texture_space");
}

void PaintMarkPass::execute(PassContext& context) {
    if (!settings_.enabled || !any_paint(context.frame().scene)) return;
    mark(context);
    for (const Technique technique : kQuick)
        for (const SeenSurface& seen : seen_surfaces(*plan_, technique, context))
            if (is_painted(*seen.surface)) light_plainly(context, seen);
}

void PaintMarkPass::mark(PassContext& context) {
    static const SurfaceShader kShader{"translucency.paint", "translucency/paint/mark.frag", {}};
    const std::string_view targets[] = {kShare, kLight, "scene_depth"};
    Frame& frame = context.frame();
    context.bind_targets(targets, -1);
    constexpr float kNothing[4] = {};
    glClearBufferfv(GL_COLOR, 0, kNothing);
    const DrawState state(DepthState::equal);
    const DrawView view{
        .clip_from_world = frame.block.view_projection, .eye = glm::vec3(frame.block.eye_near), .features = kPaint};
    frame.gpu_scene.draw(view, kShader, [&](const gpu::Program& program) {
        program.texture("light_diffuse", context.texture("light_diffuse"), {.filter = gpu::Filter::nearest});
    });
}

void PaintMarkPass::light_plainly(PassContext& context, const SeenSurface& seen) {
    static const gpu::ProgramDesc kAround{.name = "translucency.paint.plain_around",
                                          .compute = "translucency/paint/plain_around.comp"};
    Frame& frame = context.frame();
    const auto bind = [&](const gpu::Program& program) {
        bind_numbered_pixels(program, context, seen);
        program.image(kLight, context.texture(kLight), 0, true);
    };
    const gpu::Program& around = frame.shaders.program(kAround);
    around.use();
    bind_frame(around, frame);
    frame.seams.bind(Seam::indirect_light, around, context);
    bind(around);
    dispatch_pixels(seen.pixels.size);
    programs_.begin();
    for (size_t i = 0; i < frame.scene.lights.size(); ++i) {
        const gpu::Program& program = programs_.use(frame, i, [&](const gpu::Program& fresh) {
            frame.seams.bind(Seam::light_transmittance, fresh, context);
            bind(fresh);
        });
        program.set("light_index", unsigned(i));
        dispatch_pixels(seen.pixels.size);
    }
}

void PaintMixPass::declare(PassDeclaration& declaration) {
    declare_pixels(declaration);
    declaration.reads(kShare, "where paint is seen")
        .reads(kLight, "light that arrives there")
        .after("translucency.scatter_maps");
}

void PaintMixPass::execute(PassContext& context) {
    if (settings_.enabled && any_paint(context.frame().scene))
        for (size_t i = 1; i < technique_names().size(); ++i)
            for (const SeenSurface& seen : seen_surfaces(*plan_, static_cast<Technique>(i), context))
                if (is_painted(*seen.surface)) mix(context, seen, static_cast<Technique>(i));
    plan_->paints().end_frame();
}

void PaintMixPass::mix(PassContext& context, const SeenSurface& seen, Technique technique) {
    static const gpu::ProgramDesc kDesc{.name = "translucency.paint.mix", .compute = "translucency/paint/mix.comp"};
    Frame& frame = context.frame();
    const gpu::Program& program = frame.shaders.program(kDesc);
    program.use();
    bind_frame(program, frame);
    bind_numbered_pixels(program, context, seen);
    const BodyPaint* paint = plan_->paints().of(*seen.surface, settings_.model);
    binding_.set(paint, *seen.surface);
    binding_.bind(program);
    for (const char* target : {kShare, kLight})
        program.texture(target, context.texture(target), {.filter = gpu::Filter::nearest});
    // of what encloses nothing scatter_maps leaves the light as it is
    const bool plainly = technique == Technique::scatter_maps && paint && !paint->closed;
    program.set("wanders", technique == Technique::htsm || plainly ? 0.0f : 1.0f);
    program.set("stays", std::ranges::find(kQuick, technique) != std::end(kQuick) ? 1.0f : 0.0f);
    dispatch_pixels(seen.pixels.size);
}

}  // namespace tyndall::translucency
