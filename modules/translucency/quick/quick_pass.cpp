#include "quick/quick_pass.h"

#include <algorithm>

#include "core/log.h"
#include "render/frame.h"

namespace tyndall::translucency {
namespace {

constexpr const char *kThrough = "quick_through", *kSurface = "gbuffer_surface";

}  // namespace

SeamProvider interior_shading_model(std::shared_ptr<QuickTable> table) {
    return {.name = "interior",
            .include = "translucency/quick/model.glsl",
            .function = "interior_shading_model",
            .reads = {kThrough, kSurface},
            .bind =
                [table](const gpu::Program& program, PassContext& context) {
                    table->bind(program);
                    program.texture(kThrough, context.texture(kThrough), {.filter = gpu::Filter::nearest});
                    program.texture("quick_gbuffer_surface", context.texture(kSurface),
                                    {.filter = gpu::Filter::nearest});
                },
            .receiver = "interior_receiver",
            .use = [table](PassContext&) { return table->use(); }};
}

void QuickPass::declare(PassDeclaration& declaration) {
    declare_pixels(declaration);
    declaration.stage(Stage::lighting)
        .writes(kThrough, {.format = gpu::Format::rgba16}, "share of the light about a body that goes through it")
        .after("translucency.leaves");
}

void QuickPass::execute(PassContext& context) {
    table_->begin(context.frame().scene.surfaces.size());
    if (settings_.enabled) {
        for (const SeenSurface& seen : seen_surfaces(*plan_, Technique::thickness, context))
            add(context, seen, QuickKind::thickness);
        for (const SeenSurface& seen : seen_surfaces(*plan_, Technique::wrap, context))
            add(context, seen, QuickKind::wrap);
    }
    table_->upload();
    bodies_.end_frame();
    shares_.end_frame();
}

void QuickPass::add(PassContext& context, const SeenSurface& seen, QuickKind kind) {
    const Surface& surface = *seen.surface;
    QuickBody& body = bodies_.of(surface);
    const bool is_first = body.version == 0;
    if (body.update(surface, settings_, plan_->paints())) body.version = ++made_;
    if (is_first && body.size.radius == 0.0f)
        log::info("translucency: {}: a mesh that is open or flat has no size for light to go around: it is not wrapped",
                  surface.material->name);
    if (kind == QuickKind::thickness && !shares_.draw(context, seen, kThrough, body.passing, body.farthest_m)) return;
    if (has_indirect_light(context.frame())) begin_pixels(context, seen, body.interior, false);
    table_->add(seen, body, kind, lobe_of(body, optics_of(*surface.interior)));
}

/// What the scene does not say, by how many mean free paths the body is large: light that scatters much leaves evenly.
glm::vec4 QuickPass::lobe_of(const QuickBody& body, const Optics& optics) const {
    const ThicknessSettings& wanted = settings_.thickness;
    const float n = std::max(body.size.radius / mean_free_path(optics), 1e-3f), even = n / (1.0f + n);
    return {wanted.distortion < 0.0f ? even : wanted.distortion, wanted.power < 0.0f ? 1.0f + 4.0f / n : wanted.power,
            wanted.ambient < 0.0f ? even : wanted.ambient, wanted.scale};
}

}  // namespace tyndall::translucency
