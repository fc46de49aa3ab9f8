#include "leaves/leaves_pass.h"

#include <epoxy/gl.h>

#include "render/draw_state.h"
#include "render/frame.h"
#include "render/gpu_scene.h"
#include "render/light_state.h"
#include "render/material_table.h"
#include "render/seams.h"
#include "seen_surface.h"

namespace tyndall::translucency {
namespace {

/// Where in the picture leaves may be seen.
PixelRectangle pixels_of_leaves(PassContext& context) {
    PixelRectangle all;
    for (const Surface& surface : context.frame().scene.surfaces) {
        if (!is_leaf(surface)) continue;
        const PixelRectangle one = pixels_of(surface.bounds, context.frame().block.view_projection, context.size());
        if (one.empty()) continue;
        if (all.empty()) {
            all = one;
            continue;
        }
        const glm::ivec2 high = glm::max(all.low + all.size, one.low + one.size);
        all.low = glm::min(all.low, one.low);
        all.size = high - all.low;
    }
    return all;
}

void bind_leaves(const gpu::Program& program, PassContext& context, const PixelRectangle& pixels) {
    bind_lit_pixels(program, context, pixels);
    program.texture("leaf_share", context.texture("leaf_share"), {.filter = gpu::Filter::nearest});
}

}  // namespace

bool is_leaf(const Surface& surface) {
    return surface.mesh && surface.material && surface.material->diffuse_transmission > 0.0f;
}

LeavesPass::LeavesPass(const TranslucencySettings& settings)
    : settings_(settings),
      programs_({.name = "translucency.leaves.light", .compute = "translucency/leaves/light.comp"}) {}

void LeavesPass::declare(PassDeclaration& declaration) {
    declare_pixels(declaration);
    declaration.writes("leaf_share", {.format = gpu::Format::rgba16},
                       "share of the base that light from the far side leaves by, and where");
    declaration.after("translucency.paint_mix");
}

void LeavesPass::execute(PassContext& context) {
    if (!settings_.enabled) return;
    const PixelRectangle pixels = pixels_of_leaves(context);
    if (pixels.empty()) return;
    draw_shares(context);
    const RenderScene& scene = context.frame().scene;
    const bool begins = scene.lights.empty() || has_light_all_around(scene);
    if (begins) begin(context, pixels);
    add_lights(context, pixels, begins);
}

void LeavesPass::draw_shares(PassContext& context) {
    static const SurfaceShader kShader{"translucency.leaves", "translucency/leaves/share.frag", {}};
    static constexpr std::string_view kTargets[] = {"leaf_share", "scene_depth"};
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

void LeavesPass::begin(PassContext& context, const PixelRectangle& pixels) {
    static const gpu::ProgramDesc kDesc{.name = "translucency.leaves.begin",
                                        .compute = "translucency/leaves/begin.comp"};
    Frame& frame = context.frame();
    const gpu::Program& program = frame.shaders.program(kDesc);
    program.use();
    bind_frame(program, frame);
    frame.seams.bind(Seam::indirect_light, program, context);
    bind_leaves(program, context, pixels);
    dispatch_pixels(pixels.size);
}

void LeavesPass::add_lights(PassContext& context, const PixelRectangle& pixels, bool begun) {
    Frame& frame = context.frame();
    programs_.begin();
    for (size_t i = 0; i < frame.scene.lights.size(); ++i) {
        const gpu::Program& program = programs_.use(frame, i, [&](const gpu::Program& fresh) {
            frame.seams.bind(Seam::light_transmittance, fresh, context);
            bind_leaves(fresh, context, pixels);
        });
        program.set("light_index", unsigned(i));
        program.set("begins", begun || i > 0 ? 0.0f : 1.0f);
        dispatch_pixels(pixels.size);
    }
}

}  // namespace tyndall::translucency
