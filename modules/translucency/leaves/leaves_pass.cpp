#include "leaves/leaves_pass.h"

#include <epoxy/gl.h>

#include "render/draw_state.h"
#include "render/frame.h"
#include "render/gpu_scene.h"
#include "render/material_table.h"
#include "seen_surface.h"

namespace tyndall::translucency {
namespace {

constexpr const char* kShare = "leaf_share";

}  // namespace

bool is_leaf(const Surface& surface) {
    return surface.mesh && surface.material && surface.material->diffuse_transmission > 0.0f;
}

PixelRectangle pixels_of_leaves(PassContext& context) {
    PixelRectangle all;
    for (const Surface& surface : context.frame().scene.surfaces)
        if (is_leaf(surface))
            all = united(all, pixels_of(surface.bounds, context.frame().block.view_projection, context.size()));
    return all;
}

SeamProvider thin_shading_model(const TranslucencySettings& settings) {
    return {.name = "thin",
            .include = "translucency/leaves/model.glsl",
            .function = "thin_shading_model",
            .reads = {kShare},
            .bind =
                [](const gpu::Program& program, PassContext& context) {
                    program.texture(kShare, context.texture(kShare), {.filter = gpu::Filter::nearest});
                },
            .receiver = "thin_receiver",
            .use = [&settings](PassContext& context) -> ShadingModelUse {
                return {{}, settings.enabled ? pixels_of_leaves(context) : PixelRectangle{}};
            }};
}

void LeavesPass::declare(PassDeclaration& declaration) {
    declare_pixels(declaration);
    declaration.stage(Stage::lighting)
        .writes(kShare, {.format = gpu::Format::rgba16},
                "share of the base that light from the far side leaves by, and where");
}

void LeavesPass::execute(PassContext& context) {
    if (!settings_.enabled) return;
    const PixelRectangle pixels = pixels_of_leaves(context);
    if (pixels.empty()) return;
    draw_shares(context);
    if (has_indirect_light(context.frame())) light_from_around(context, pixels);
}

void LeavesPass::draw_shares(PassContext& context) {
    static const SurfaceShader kShader{"translucency.leaves", "translucency/leaves/share.frag", {}};
    static constexpr std::string_view kTargets[] = {kShare, "scene_depth"};
    Frame& frame = context.frame();
    context.bind_targets(kTargets, -1);
    constexpr float kNothing[4] = {};
    glClearBufferfv(GL_COLOR, 0, kNothing);
    const DrawState state(DepthState::equal);
    const DrawView view{.clip_from_world = frame.block.view_projection,
                        .eye = glm::vec3(frame.block.eye_near),
                        .features = kDiffuseTransmission};
    frame.gpu_scene.draw(view, kShader, {});
}

void LeavesPass::light_from_around(PassContext& context, const PixelRectangle& pixels) {
    static const gpu::ProgramDesc kDesc{.name = "translucency.leaves.around",
                                        .compute = "translucency/leaves/around.comp"};
    Frame& frame = context.frame();
    const gpu::Program& program = frame.shaders.program(kDesc);
    program.use();
    bind_frame(program, frame);
    frame.seams.bind(Seam::indirect_light, program, context);
    bind_lit_pixels(program, context, pixels);
    program.texture(kShare, context.texture(kShare), {.filter = gpu::Filter::nearest});
    dispatch_pixels(pixels.size);
}

}  // namespace tyndall::translucency
