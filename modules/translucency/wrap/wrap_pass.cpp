#include "wrap/wrap_pass.h"

#include "core/log.h"
#include "render/frame.h"
#include "render/light_state.h"
#include "render/seams.h"

namespace tyndall::translucency {
WrapPass::WrapPass(std::shared_ptr<TechniquePlan> plan, const TranslucencySettings& settings)
    : plan_(std::move(plan)),
      settings_(settings),
      programs_({.name = "translucency.wrap.light", .compute = "translucency/wrap/light.comp"}) {}

void WrapPass::declare(PassDeclaration& declaration) {
    declare_pixels(declaration);
    declaration.after("translucency.thickness");
}

void WrapPass::execute(PassContext& context) {
    if (settings_.enabled)
        for (const SeenSurface& seen : seen_surfaces(*plan_, Technique::wrap, context))
            render(context, seen, object_of(*seen.surface));
    objects_.end_frame();
}

const WrapPass::Object& WrapPass::object_of(const Surface& surface) {
    Object& object = objects_.of(surface);
    const bool reshaped = object.size.update(surface.mesh->mesh, glm::mat3(surface.transform));
    if (reshaped && object.size.radius == 0.0f)
        log::info("translucency: {}: a mesh that is open or flat has no size for light to go around: it is not wrapped",
                  surface.material->name);
    const Optics optics = optics_of(*surface.interior);
    if (object.interior.update(
            {optics, settings_.model, settings_.scaling, mean_free_path(optics), object.size.radius}) ||
        reshaped)
        object.wrap = wrap_amount(optics, settings_.model, object.size.radius);
    object.interior.paint(plan_->paints().of(surface, settings_.model), surface);
    return object;
}

void WrapPass::render(PassContext& context, const SeenSurface& seen, const Object& object) {
    Frame& frame = context.frame();
    const size_t lights = frame.scene.lights.size();
    const bool begins = lights == 0 || has_light_all_around(frame.scene);
    if (begins) begin_pixels(context, seen, object.interior, false);
    const Bounds& bounds = seen.surface->bounds;
    programs_.begin();
    for (size_t i = 0; i < lights; ++i) {
        const gpu::Program& program = programs_.use(frame, i, [&](const gpu::Program& fresh) {
            frame.seams.bind(Seam::light_transmittance, fresh, context);
            bind_pixels(fresh, context, seen, object.interior);
            fresh.set("wrap_a", object.wrap.a);
            fresh.set("wrap_lift", 0.5f * object.wrap.a * object.wrap.a * object.size.radius);
            fresh.set("wrap_wide", object.wrap.wide);
            fresh.set("wrap_even", object.wrap.even);
            fresh.set("body_ball", glm::vec4(bounds.centre(), 0.5f * glm::distance(bounds.low, bounds.high)));
        });
        program.set("light_index", unsigned(i));
        program.set("keeps", begins || i > 0 ? 1.0f : 0.0f);
        dispatch_columns(seen.pixels.size);
    }
}

}  // namespace tyndall::translucency
