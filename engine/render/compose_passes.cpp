#include "render/compose_passes.h"

#include <initializer_list>

#include "render/draw_state.h"
#include "render/frame.h"

namespace tyndall {
namespace {

constexpr std::initializer_list<const char*> kComposeReads{"scene_depth",      "gbuffer_normal",   "gbuffer_base",
                                                           "gbuffer_f0",       "gbuffer_emissive", "light_diffuse",
                                                           "light_specular_a", "light_specular_b"};

/// The program in use with the frame bound.
const gpu::Program& use(const gpu::ProgramDesc& desc, PassContext& context) {
    const gpu::Program& program = context.frame().shaders.program(desc);
    program.use();
    bind_frame(program, context.frame());
    return program;
}

}  // namespace

void ComposePass::declare(PassDeclaration& declaration) {
    declaration.stage(Stage::compose)
        .writes("radiance", {.format = gpu::Format::rgba32f}, "scene-linear radiance, cd/m2");
    for (const char* name : kComposeReads) declaration.reads(name, "light and material");
}

void ComposePass::execute(PassContext& context) {
    static const gpu::ProgramDesc kDesc{.name = "compose", .fragment = "render/shaders/compose.frag"};
    context.bind_targets();
    const gpu::Program& program = use(kDesc, context);
    for (const char* name : kComposeReads)
        program.texture(name, context.texture(name), {.filter = gpu::Filter::nearest});
    table_.bind(program);
    gpu::draw_fullscreen();
}

void SkyPass::declare(PassDeclaration& declaration) {
    declaration.stage(Stage::sky).reads("scene_depth", "where nothing is").updates("radiance", "the sky behind it all");
    seams_.declare(Seam::sky, declaration);
}

void SkyPass::execute(PassContext& context) {
    static const gpu::ProgramDesc kDesc{.name = "sky", .fragment = "render/shaders/sky.frag"};
    static constexpr std::string_view kTargets[] = {"radiance", "scene_depth"};
    context.bind_targets(kTargets, -1);
    const gpu::Program& program = use(kDesc, context);
    seams_.bind(Seam::sky, program, context);
    const DrawState state(DepthState::equal);  // the full-screen triangle lies at infinity, depth 0
    gpu::draw_fullscreen();
}

void MediaPass::declare(PassDeclaration& declaration) {
    declaration.stage(Stage::media)
        .reads("scene_depth", "where the segment ends")
        .updates("radiance", "dimmed, with the scattered light added");
    seams_.declare(Seam::media_segment, declaration);
}

void MediaPass::execute(PassContext& context) {
    static const gpu::ProgramDesc kDesc{
        .name = "media", .fragment = "render/shaders/media.frag", .defines = {"MEDIA_SEGMENT_OF_SURFACE"}};
    context.bind_targets();
    const gpu::Program& program = use(kDesc, context);
    program.texture("scene_depth", context.texture("scene_depth"), {.filter = gpu::Filter::nearest});
    seams_.bind(Seam::media_segment, program, context);
    const DrawState state(DepthState::off, BlendState::attenuate_add);
    gpu::draw_fullscreen();
}

}  // namespace tyndall
